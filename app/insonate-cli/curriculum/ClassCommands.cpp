#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/curriculum/CohortStore.h>

#include <memory>

namespace insonate::cli {
namespace {

struct MembershipArguments {
  std::string className, person;
  bool teaches = false;
};

struct CurriculumArguments {
  std::string className, curriculum;
  int version = 0;
};

Json classJson(const Cohort& cohort) {
  const bool taught = !cohort.curriculum.empty();
  return {{"id", cohort.id},
          {"name", cohort.name},
          {"curriculum", taught ? Json(cohort.curriculum) : Json(nullptr)},
          {"curriculum_version", taught ? Json(cohort.curriculumVersion) : Json(nullptr)}};
}

Result<Answer> listClasses(const SignedIn& by) {
  const auto cohorts = CohortStore(by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  Json rows = Json::array();
  for (const Cohort& cohort : *cohorts) rows.push_back(classJson(cohort));
  const std::string none = "You are not in a class yet. An administrator adds classes with 'curriculum classes add'.";
  return Answer{
      {{"classes", rows}},
      rows.empty()
          ? none
          : tableOf(rows, {{"name", "name"}, {"curriculum", "curriculum"}, {"curriculum_version", "version"}})};
}

Result<Answer> add(const SignedIn& by, const std::string& name) {
  const auto cohort = CohortStore(by).add(name);
  if (!cohort) return tl::unexpected(cohort.error());
  return Answer{{{"class", classJson(*cohort)}},
                "The class '" + cohort->name + "' was added. Next: 'curriculum classes import' or 'join'."};
}

Json rowOf(const Member& member, const std::map<std::string, Standing>& standings) {
  Json row = toJson(member.person);
  row.update({{"teaches", member.teaches},
              {"attempts", nullptr},
              {"last_attempt", nullptr},
              {"level", nullptr},
              {"mastered", nullptr},
              {"why", nullptr}});
  if (member.teaches) return row;
  row["attempts"] = member.attempts;
  if (member.lastAttempt_us) row["last_attempt"] = timeText(*member.lastAttempt_us);
  const auto found = standings.find(member.person.id);
  if (found == standings.end()) return row;
  const Standing& standing = found->second;
  row["mastered"] = standing.mastered;
  row["level"] = standing.level.empty() ? Json(nullptr) : Json(standing.level);
  row["why"] = standing.sentence;
  return row;
}

Result<Answer> members(const SignedIn& by, const std::string& name) {
  const auto cohort = classNamed(by, name);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto members = CohortStore(by).members(cohort->id);
  if (!members) return tl::unexpected(members.error());
  std::map<std::string, Standing> standings;
  if (!cohort->curriculum.empty()) {
    auto now = standingsOf(by, *cohort, *members);
    if (!now) return tl::unexpected(now.error());
    standings = std::move(*now);
  }
  Json rows = Json::array();
  for (const Member& member : *members) rows.push_back(rowOf(member, standings));
  const std::string none =
      "No person is in the class '" + cohort->name + "' yet. Next: 'curriculum classes import' or 'join'.";
  return Answer{{{"class", classJson(*cohort)}, {"members", rows}},
                rows.empty() ? none
                             : tableOf(rows, {{"name", "name"},
                                              {"full_name", "full name"},
                                              {"teaches", "teaches"},
                                              {"attempts", "attempts"},
                                              {"level", "level"},
                                              {"mastered", "mastered"},
                                              {"why", "why"}})};
}

Result<Answer> join(const SignedIn& by, const MembershipArguments& a, bool joins) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto person = personNamed(by, a.person);
  if (!person) return tl::unexpected(person.error());
  const CohortStore cohorts(by);
  const auto done = joins ? cohorts.join(cohort->id, person->id, a.teaches) : cohorts.leave(cohort->id, person->id);
  if (!done) return tl::unexpected(done.error());
  const std::string verb = joins ? (a.teaches ? " teaches in '" : " learns in '") : " is no longer in '";
  return Answer{{{"class", classJson(*cohort)}, {"person", toJson(*person)}},
                person->name + verb + cohort->name + "'."};
}

Result<Answer> setCurriculum(const SignedIn& by, const CurriculumArguments& a) {
  auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto curriculum = publishedCurriculum(by, a.curriculum, a.version);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto done = CohortStore(by).setCurriculum(cohort->id, curriculum->name, curriculum->version);
  if (!done) return tl::unexpected(done.error());
  cohort->curriculum = curriculum->name, cohort->curriculumVersion = curriculum->version;
  return Answer{{{"class", classJson(*cohort)}},
                "'" + cohort->name + "' is taught by " + curriculum->title + ", version " +
                    std::to_string(curriculum->version) + "."};
}

void addMemberships(CLI::App& classes, Outcome& outcome) {
  const auto add = [&](const char* verb, const char* about, bool joins) {
    auto a = std::make_shared<MembershipArguments>();
    CLI::App* command =
        addSignedInCommand(classes, outcome, verb, about, [=](const SignedIn& by) { return join(by, *a, joins); });
    command->add_option("CLASS", a->className, "Name of the class")->required();
    command->add_option("NAME", a->person, "Name of the person")->required();
    return std::pair(command, a);
  };
  const auto [command, a] = add("join", "Add a person to a class, as a trainee or an instructor", true);
  command->add_flag("--teaches", a->teaches, "Add the person as an instructor");
  add("leave", "Remove a person from a class", false);
}

}  // namespace

void addClassCommands(CLI::App& curriculum, Outcome& outcome) {
  CLI::App& classes = *curriculum.add_subcommand("classes", "Manage classes and their curricula");
  classes.require_subcommand(1);
  addSignedInCommand(classes, outcome, "list", "List the classes that you can see", listClasses);
  auto name = std::make_shared<std::string>();
  addSignedInCommand(classes, outcome, "add", "Add a class", [name](const SignedIn& by) { return add(by, *name); })
      ->add_option("CLASS", *name, "Name")
      ->required();
  auto which = std::make_shared<std::string>();
  addSignedInCommand(classes, outcome, "members", "List the people of a class with their levels",
                     [which](const SignedIn& by) { return members(by, *which); })
      ->add_option("CLASS", *which, "Name of the class")
      ->required();
  addMemberships(classes, outcome);
  auto a = std::make_shared<CurriculumArguments>();
  CLI::App* command = addSignedInCommand(classes, outcome, "curriculum", "Set the published curriculum of a class",
                                         [a](const SignedIn& by) { return setCurriculum(by, *a); });
  command->add_option("CLASS", a->className, "Name of the class")->required();
  command->add_option("CURRICULUM", a->curriculum, "Name of the published curriculum")->required();
  command->add_option("VERSION", a->version, "Version (default: the newest)")->check(CLI::PositiveNumber);
  addClassImport(classes, outcome);
}

}  // namespace insonate::cli
