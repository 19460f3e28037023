#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/DemoClass.h>

#include <cstdio>

namespace insonate {
namespace {

const std::string kMadeUpName = "made-up-";

std::string numberOf(int trainee) {
  char number[16];
  std::snprintf(number, sizeof number, "%03d", trainee + 1);
  return number;
}

struct Classes {
  std::string all, half;
};

/// A new person, who has chosen the password.
Result<SignedIn> enrol(const CurriculumStore& store, const SignedIn& administrator, const NewPerson& person,
                       const std::string& password) {
  const std::string first = password + ", set by the administrator";
  const auto added = PeopleStore(administrator).add(person, first);
  if (!added) return tl::unexpected(added.error());
  auto by = store.signIn(person.name, first);
  if (!by) return by;
  if (auto chosen = PeopleStore(*by).changeOwnPassword(first, password); !chosen) return tl::unexpected(chosen.error());
  return by;
}

Result<Classes> makeClasses(const CurriculumStore& store, const SignedIn& administrator, const std::string& password) {
  const auto teacher =
      enrol(store, administrator, {kDemoInstructor, "Made-up teacher", "", Role::Instructor}, password);
  if (!teacher) return tl::unexpected(teacher.error());
  const CohortStore cohorts(administrator);
  std::vector<std::string> ids;
  for (const char* name : {kDemoClass, kDemoHalfClass}) {
    const auto cohort = cohorts.add(name);
    if (!cohort) return tl::unexpected(cohort.error());
    if (auto joined = cohorts.join(cohort->id, teacher->person().id, true); !joined)
      return tl::unexpected(joined.error());
    ids.push_back(cohort->id);
  }
  return Classes{ids[0], ids[1]};
}

Result<void> teach(const SignedIn& administrator, const Curriculum& curriculum, const Classes& classes) {
  const auto published =
      PublishedCurricula(administrator).publish(curriculum.name, curriculum.version, curriculumText(curriculum));
  if (!published) return tl::unexpected(published.error());
  for (const std::string& cohort : {classes.all, classes.half})
    if (auto set = CohortStore(administrator).setCurriculum(cohort, curriculum.name, curriculum.version); !set)
      return set;
  return {};
}

Result<void> practise(const SignedIn& trainee, const std::vector<AttemptFacts>& attempts) {
  const AttemptStore store(trainee);
  for (const AttemptFacts& facts : attempts)
    if (const auto added = store.add(facts); !added) return tl::unexpected(added.error());
  return {};
}

}  // namespace

Result<void> makeDemoClass(const CurriculumStore& store, const Curriculum& curriculum, const DemoClassPlan& plan,
                           const std::string& password, const Progress& progress) {
  const auto administrator =
      store.createFirstAdministrator({kDemoAdministrator, "Made-up administrator", "", Role::Administrator}, password);
  if (!administrator) return tl::unexpected(administrator.error());
  const auto classes = makeClasses(store, *administrator, password);
  if (!classes) return tl::unexpected(classes.error());
  for (int i = 0; i < plan.trainees; ++i) {
    if (!report(progress, "Making up trainees", static_cast<double>(i) / plan.trainees))
      return fail(std::string(kCancelled));
    const std::string number = numberOf(i);
    const auto trainee =
        enrol(store, *administrator, {kMadeUpName + number, "Made-up trainee " + number, "", Role::Trainee}, password);
    if (!trainee) return tl::unexpected(trainee.error());
    const auto attempts = demoAttempts(curriculum, i, plan);
    if (!attempts) return tl::unexpected(attempts.error());
    if (auto practised = practise(*trainee, *attempts); !practised) return practised;
    // Joins only now: for a member of a cohort, the store computes a standing after each attempt.
    for (const std::string& cohort : {classes->all, classes->half})
      if (cohort == classes->all || 2 * i >= plan.trainees)
        if (auto joined = CohortStore(*administrator).join(cohort, trainee->person().id, false); !joined) return joined;
  }
  // Publishes last, since the store refuses attempts at a level from before its publication, and the invented attempts
  // lie in the past.
  if (auto taught = teach(*administrator, curriculum, *classes); !taught) return taught;
  report(progress, "Making up trainees", 1);
  return {};
}

Result<void> addRecordedAttempts(const CurriculumStore& store, const Curriculum& curriculum,
                                 const std::vector<std::filesystem::path>& recordings, const std::string& password) {
  const Level& level = curriculum.levels.front();
  int trainee = 0;
  for (const std::filesystem::path& recording : recordings) {
    auto facts = factsOfRecording(recording, Hands::PersonOrScript);
    if (!facts) return tl::unexpected(facts.error());
    if (facts->procedure != level.procedure)
      return fail(recording.string() + " is an attempt at '" + facts->procedure + "', and level '" + level.name +
                  "' asks for '" + level.procedure + "'; record another one.");
    facts->curriculum = curriculum.name, facts->curriculumVersion = curriculum.version, facts->level = level.name;
    facts->proof = AttemptProof::Demonstration;
    const auto by = store.signIn(kMadeUpName + numberOf(trainee++), password);
    if (!by) return tl::unexpected(by.error());
    if (auto kept = practise(*by, {std::move(*facts)}); !kept) return kept;
  }
  return {};
}

}  // namespace insonate
