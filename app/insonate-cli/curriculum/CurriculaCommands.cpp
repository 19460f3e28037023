#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/teaching/TeachingHere.h>

#include <memory>

namespace insonate::cli {
namespace {

/// A preset or a file, and whether all that it names is here.
Result<Curriculum> checked(const std::string& nameOrPath) {
  auto curriculum = loadCurriculum(nameOrPath);
  if (!curriculum) return curriculum;
  const auto names = teachingNames();
  if (!names) return tl::unexpected(names.error());
  if (auto fine = checkNames(*curriculum, *names); !fine) return tl::unexpected(fine.error());
  return curriculum;
}

Json levelsOf(const Curriculum& curriculum) {
  Json levels = Json::array();
  for (const Level& level : curriculum.levels)
    levels.push_back({{"level", level.name},
                      {"title", level.title},
                      {"case", level.caseName},
                      {"procedure", level.procedure},
                      {"prerequisites", level.prerequisites},
                      {"standards", level.pass.standards.size()},
                      {"passes_in_a_row", level.mastery.consecutivePasses}});
  return levels;
}

Answer toldOf(const Curriculum& curriculum, const std::string& sentence) {
  const Json levels = levelsOf(curriculum);
  return {{{"name", curriculum.name},
           {"curriculum_version", curriculum.version},
           {"title", curriculum.title},
           {"levels", levels}},
          tableOf(levels, {{"level", "level"},
                           {"case", "case"},
                           {"procedure", "procedure"},
                           {"standards", "standards"},
                           {"passes_in_a_row", "passes in a row"}}) +
              sentence};
}

std::string versioned(const Curriculum& curriculum) {
  return "'" + curriculum.name + "', version " + std::to_string(curriculum.version);
}

Result<Answer> check(const std::string& nameOrPath) {
  const auto curriculum = checked(nameOrPath);
  if (!curriculum) return tl::unexpected(curriculum.error());
  return toldOf(*curriculum, versioned(*curriculum) + ", can be taught here.");
}

Result<Answer> publish(const SignedIn& by, const std::string& nameOrPath) {
  const auto curriculum = checked(nameOrPath);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto entry = PublishedCurricula(by).publish(curriculum->name, curriculum->version, curriculumText(*curriculum));
  if (!entry) return tl::unexpected(entry.error());
  Answer answer =
      toldOf(*curriculum,
             versioned(*curriculum) + ", is published. To assign it to a class, use 'curriculum classes curriculum'.");
  answer.object["hash"] = entry->hash;
  return answer;
}

Result<Answer> listCurricula(const SignedIn& by) {
  const auto published = PublishedCurricula(by).list();
  if (!published) return tl::unexpected(published.error());
  Json rows = Json::array();
  for (const CurriculumEntry& entry : *published)
    rows.push_back({{"name", entry.name},
                    {"curriculum_version", entry.version},
                    {"published", timeText(entry.published_us)},
                    {"by", entry.publishedBy},
                    {"hash", entry.hash}});
  std::string none =
      "No curriculum is published yet. 'curriculum publish' takes a file or one of these built-in curricula:";
  for (const std::string& name : curriculumPresetNames()) none += " " + name;
  return Answer{
      {{"curricula", rows}},
      rows.empty()
          ? none
          : tableOf(rows,
                    {{"name", "name"}, {"curriculum_version", "version"}, {"published", "published"}, {"by", "by"}})};
}

struct ShowArguments {
  std::string name;
  int version = 0;
};

Result<Answer> show(const SignedIn& by, const ShowArguments& a) {
  const auto curriculum = publishedCurriculum(by, a.name, a.version);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const std::string text = curriculumText(*curriculum);
  return Answer{{{"curriculum", Json::parse(text)}}, text};
}

}  // namespace

void addCurriculaCommands(CLI::App& curriculum, Outcome& outcome) {
  auto named = std::make_shared<std::string>(), published = std::make_shared<std::string>();
  addAnsweringCommand(curriculum, outcome, "check", "Check whether a curriculum can be taught here",
                      [named] { return check(*named); })
      ->add_option("CURRICULUM", *named, "JSON file, or a built-in curriculum")
      ->required();
  addSignedInCommand(curriculum, outcome, "list", "Published curricula", listCurricula);
  addSignedInCommand(curriculum, outcome, "publish",
                     "Publish a version of a curriculum, which cannot be changed afterwards",
                     [published](const SignedIn& by) { return publish(by, *published); })
      ->add_option("CURRICULUM", *published, "JSON file, or a built-in curriculum")
      ->required();
  auto a = std::make_shared<ShowArguments>();
  CLI::App* command = addSignedInCommand(curriculum, outcome, "show", "Print a published curriculum as JSON",
                                         [a](const SignedIn& by) { return show(by, *a); });
  command->add_option("CURRICULUM", a->name, "Name of the published curriculum")->required();
  command->add_option("VERSION", a->version, "Version (default: the newest)")->check(CLI::PositiveNumber);
}

}  // namespace insonate::cli
