#include "Lookup.h"

#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>

#include <nlohmann/json.hpp>

#include <QtCore/QString>
#include <QtCore/QUuid>
#include <algorithm>

namespace insonate::cli {
namespace {

QString keyOf(const std::string& name) {
  return QString::fromStdString(name).normalized(QString::NormalizationForm_KC).toCaseFolded();
}

}  // namespace

bool sameName(const std::string& one, const std::string& other) {
  return keyOf(one) == keyOf(other);
}

Result<std::vector<Person>> visiblePeople(const SignedIn& by) {
  if (by.person().role == Role::Administrator) return PeopleStore(by).all();
  std::vector<Person> people;
  const auto cohorts = CohortStore(by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  for (const Cohort& cohort : *cohorts) {
    const auto members = CohortStore(by).members(cohort.id);
    if (!members) return tl::unexpected(members.error());
    for (const Member& member : *members) people.push_back(member.person);
  }
  return people;
}

Result<Person> personNamed(const SignedIn& by, const std::string& nameOrId) {
  if (nameOrId.empty() || sameName(nameOrId, by.person().name)) return by.person();
  // A trainee has no list to look names up in: the store refuses, and writes down that they asked.
  const bool isId = !QUuid::fromString(QString::fromStdString(nameOrId)).isNull();
  if (isId || by.person().role == Role::Trainee) return PeopleStore(by).person(nameOrId);
  const auto people = visiblePeople(by);
  if (!people) return tl::unexpected(people.error());
  const auto found = std::ranges::find_if(*people, [&](const Person& p) { return sameName(p.name, nameOrId); });
  if (found == people->end())
    return fail("There is no '" + nameOrId + "' among the people that " + by.person().name +
                " can see. 'curriculum people list' and 'curriculum classes members' list them.");
  return *found;
}

Result<Cohort> classNamed(const SignedIn& by, const std::string& nameOrId) {
  const auto cohorts = CohortStore(by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  const auto found = std::ranges::find_if(
      *cohorts, [&](const Cohort& cohort) { return cohort.id == nameOrId || sameName(cohort.name, nameOrId); });
  if (found != cohorts->end()) return *found;
  return fail("There is no class '" + nameOrId + "' among the classes that " + by.person().name +
              " can see. 'curriculum classes list' lists them.");
}

Result<std::vector<Cohort>> classesOf(const SignedIn& by, const Person& person) {
  auto cohorts = CohortStore(by).cohorts();
  const bool ownAsTrainee = person.id == by.person().id && by.person().role == Role::Trainee;
  if (!cohorts || ownAsTrainee) return cohorts;
  std::vector<Cohort> learnsIn;
  for (Cohort& cohort : *cohorts) {
    const auto members = CohortStore(by).members(cohort.id);
    if (!members) return tl::unexpected(members.error());
    const bool learns = std::ranges::any_of(
        *members, [&](const Member& member) { return member.person.id == person.id && !member.teaches; });
    if (learns) learnsIn.push_back(std::move(cohort));
  }
  return learnsIn;
}

Result<Curriculum> publishedCurriculum(const SignedIn& by, const std::string& name, int version) {
  const PublishedCurricula published(by);
  if (version == 0) {
    const auto list = published.list();
    if (!list) return tl::unexpected(list.error());
    for (const CurriculumEntry& entry : *list)
      if (entry.name == name) version = std::max(version, entry.version);
    if (version == 0)
      return fail("No curriculum '" + name + "' has been published. 'curriculum list' lists the published curricula.");
  }
  const auto text = published.text(name, version);
  if (!text) return tl::unexpected(text.error());
  return parseCurriculum(*text);
}

Result<Curriculum> curriculumOf(const SignedIn& by, const Cohort& cohort) {
  if (cohort.curriculum.empty())
    return fail("The class '" + cohort.name + "' has no curriculum yet; set one with 'curriculum classes curriculum'.");
  return publishedCurriculum(by, cohort.curriculum, cohort.curriculumVersion);
}

Result<std::map<std::string, Standing>> standingsOf(const SignedIn& by, const Cohort& cohort,
                                                    const std::vector<Member>& members) {
  std::vector<std::string> learners;
  for (const Member& member : members)
    if (!member.teaches) learners.push_back(member.person.id);
  return CohortStore(by).standings(cohort.id, learners);
}

const char* nameOf(Role role) {
  switch (role) {
    case Role::Trainee:
      return "trainee";
    case Role::Instructor:
      return "instructor";
    case Role::Administrator:
      break;
  }
  return "administrator";
}

const char* nameOf(AttemptState state) {
  switch (state) {
    case AttemptState::Open:
      return "open";
    case AttemptState::Completed:
      return "completed";
    case AttemptState::Abandoned:
      return "abandoned";
    case AttemptState::Voided:
      break;
  }
  return "voided";
}

nlohmann::json toJson(const Person& person) {
  return {{"id", person.id},       {"name", person.name},         {"full_name", person.fullName},
          {"email", person.email}, {"role", nameOf(person.role)}, {"disabled", person.disabled}};
}

}  // namespace insonate::cli
