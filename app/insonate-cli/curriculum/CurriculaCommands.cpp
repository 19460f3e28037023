#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/site/PublishedCases.h>
#include <insonate/teaching/TeachingHere.h>

#include <memory>

namespace insonate::cli {
namespace {

struct CheckArguments {
  std::string nameOrPath;
  std::string cases;  ///< folder with the folders of cases that levels may name, besides the built-in cases
};

/// A preset or a file, and whether all that it names is here.
Result<Curriculum> checked(const CheckArguments& a) {
  auto curriculum = loadCurriculum(a.nameOrPath);
  if (!curriculum) return curriculum;
  const auto titles = PublishedCases(a.cases).offeredTitles();
  if (!titles) return tl::unexpected(titles.error());
  const auto names = teachingNames(*titles);
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
                           {"passes_in_a_row", "passed in a row"}}) +
              sentence};
}

std::string versioned(const Curriculum& curriculum) {
  return "'" + curriculum.name + "', version " + std::to_string(curriculum.version);
}

Result<Answer> check(const CheckArguments& a) {
  const auto curriculum = checked(a);
  if (!curriculum) return tl::unexpected(curriculum.error());
  return toldOf(*curriculum, versioned(*curriculum) + ", can be taught here.");
}

Result<Answer> publish(const SignedIn& by, const CheckArguments& a) {
  const auto curriculum = checked(a);
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
  const auto addOptions = [](CLI::App* command, CheckArguments& into) {
    command->add_option("CURRICULUM", into.nameOrPath, "JSON file, or a built-in curriculum")->required();
    command
        ->add_option(
            "--cases", into.cases,
            "Folder with the folders of published cases, such as that of insonate-server; levels may name these "
            "cases by their titles")
        ->check(CLI::ExistingDirectory);
  };
  auto named = std::make_shared<CheckArguments>(), published = std::make_shared<CheckArguments>();
  addOptions(addAnsweringCommand(curriculum, outcome, "check", "Check whether a curriculum can be taught here",
                                 [named] { return check(*named); }),
             *named);
  addSignedInCommand(curriculum, outcome, "list", "Published curricula", listCurricula);
  addOptions(addSignedInCommand(curriculum, outcome, "publish",
                                "Publish a version of a curriculum, which cannot be changed afterwards",
                                [published](const SignedIn& by) { return publish(by, *published); }),
             *published);
  auto a = std::make_shared<ShowArguments>();
  CLI::App* command = addSignedInCommand(curriculum, outcome, "show", "Print a published curriculum as JSON",
                                         [a](const SignedIn& by) { return show(by, *a); });
  command->add_option("CURRICULUM", a->name, "Name of the published curriculum")->required();
  command->add_option("VERSION", a->version, "Version (default: the newest)")->check(CLI::PositiveNumber);
}

}  // namespace insonate::cli
