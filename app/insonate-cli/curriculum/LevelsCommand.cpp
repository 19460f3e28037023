#include "Answer.h"
#include "Groups.h"
#include "LevelPath.h"
#include "Lookup.h"

#include <memory>

namespace insonate::cli {
namespace {

Result<Answer> levels(const SignedIn& by, const std::string& name) {
  const auto person = personNamed(by, name);
  if (!person) return tl::unexpected(person.error());
  const auto cohorts = classesOf(by, *person);
  if (!cohorts) return tl::unexpected(cohorts.error());
  Answer answer{{{"person", toJson(*person)}, {"paths", Json::array()}}, ""};
  for (const Cohort& cohort : *cohorts) {
    if (cohort.curriculum.empty()) continue;
    const auto curriculum = curriculumOf(by, cohort);
    if (!curriculum) return tl::unexpected(curriculum.error());
    const auto path = levelPath(by, *curriculum, person->id);
    if (!path) return tl::unexpected(path.error());
    Json rows = toJson(*curriculum, *path);
    answer.text += cohort.name + ": " + curriculum->title + ", version " + std::to_string(curriculum->version) + "\n" +
                   tableOf(rows, {{"level", "level"},
                                  {"state", "state"},
                                  {"passes_in_a_row", "in a row"},
                                  {"passes_needed", "of"},
                                  {"fewest_attempts", "attempts at least"},
                                  {"why", "why"}});
    answer.object["paths"].push_back({{"class", cohort.name},
                                      {"curriculum", curriculum->name},
                                      {"curriculum_version", curriculum->version},
                                      {"levels", std::move(rows)}});
  }
  if (answer.text.empty())
    answer.text = person->name +
                  " is not a trainee of a class with a curriculum. See 'curriculum classes join' and 'curriculum "
                  "classes curriculum'.";
  return answer;
}

}  // namespace

void addLevelsCommand(CLI::App& curriculum, Outcome& outcome) {
  auto name = std::make_shared<std::string>();
  addSignedInCommand(curriculum, outcome, "levels",
                     "Print a person's levels: open, mastered, lapsed or locked, with the reason",
                     [name](const SignedIn& by) { return levels(by, *name); })
      ->add_option("NAME", *name, "Name of the person (default: you)");
}

}  // namespace insonate::cli
