#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/teaching/ClassExports.h>

#include <map>
#include <memory>
#include <optional>

namespace insonate::cli {
namespace {

struct ExportArguments {
  std::string file, className, item = "Insonate";
  XapiSite site;
  GradeKey key = GradeKey::Email;
};

Answer wrote(const std::string& file, Json fields) {
  fields["file"] = file;
  return {std::move(fields), "Wrote " + file + "."};
}

Result<Answer> exportAll(const SignedIn& by, const std::string& file) {
  if (auto done = StoreUpkeep(by).exportJson(file); !done) return tl::unexpected(done.error());
  return wrote(file, Json::object());
}

/// None for a class without a curriculum: nothing is passed there.
Result<std::optional<Curriculum>> curriculumIfAny(const SignedIn& by, const Cohort& cohort) {
  if (cohort.curriculum.empty()) return std::nullopt;
  auto curriculum = curriculumOf(by, cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  return std::move(*curriculum);
}

Result<Answer> writeAttempts(const SignedIn& by, const ExportArguments& a) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto curriculum = curriculumIfAny(by, *cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto table = exportAttempts(by, *cohort, *curriculum ? &**curriculum : nullptr);
  if (!table) return tl::unexpected(table.error());
  if (auto written = writeAtomically(a.file, table->csv); !written) return tl::unexpected(written.error());
  return wrote(a.file, {{"attempts", table->attempts}});
}

/// "Left out: Bob B (no grade yet), ..."; "" for nobody.
std::string ungradedSentence(const std::vector<UngradedPerson>& leftOut) {
  std::string sentence;
  for (const UngradedPerson& one : leftOut)
    sentence += (sentence.empty() ? " Left out: " : ", ") + one.fullName + " (" + one.why + ")";
  return sentence.empty() ? "" : sentence + ".";
}

Result<Answer> writeGrades(const SignedIn& by, const ExportArguments& a) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto curriculum = curriculumOf(by, *cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto made = exportGrades(by, *cohort, *curriculum, a.item, a.key);
  if (!made) return tl::unexpected(made.error());
  if (auto written = writeAtomically(a.file, made->book.csv); !written) return tl::unexpected(written.error());
  Json names = Json::array(), reasons = Json::array();
  for (const UngradedPerson& one : made->book.leftOut) names.push_back(one.fullName), reasons.push_back(one.why);
  Answer answer = wrote(
      a.file, {{"grades", made->grades}, {"left_out", std::move(names)}, {"left_out_because", std::move(reasons)}});
  answer.text += ungradedSentence(made->book.leftOut);
  return answer;
}

Result<Answer> writeStatements(const SignedIn& by, const ExportArguments& a) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto curriculum = curriculumOf(by, *cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto all = exportStatements(by, *cohort, *curriculum, a.site);
  if (!all) return tl::unexpected(all.error());
  if (auto written = writeXapi(a.file, all->statements); !written) return tl::unexpected(written.error());
  Json leftOut = Json::array();
  for (const LeftOutAttempt& one : all->leftOut) leftOut.push_back({{"id", one.attempt}, {"why", one.why}});
  Answer answer = wrote(a.file, {{"statements", all->statements.size()}, {"left_out", std::move(leftOut)}});
  if (!all->leftOut.empty()) answer.text += " " + leftOutSentence(all->leftOut);
  return answer;
}

using Export = Result<Answer> (*)(const SignedIn&, const ExportArguments&);

std::pair<CLI::App*, std::shared_ptr<ExportArguments>> addClassExport(CLI::App& exports, Outcome& outcome,
                                                                      const char* name, const char* about, Export run) {
  auto a = std::make_shared<ExportArguments>();
  CLI::App* command =
      addSignedInCommand(exports, outcome, name, about, [a, run](const SignedIn& by) { return run(by, *a); });
  command->add_option("CLASS", a->className, "Name of the class")->required();
  command->add_option("FILE", a->file, "File to write")->required()->check(notEmpty());
  return {command, a};
}

}  // namespace

void addExportCommands(CLI::App& curriculum, Outcome& outcome) {
  CLI::App& exports = *curriculum.add_subcommand("export", "Write stored data for other programs");
  exports.require_subcommand(1);
  auto file = std::make_shared<std::string>();
  addSignedInCommand(exports, outcome, "json", "Write all data except passwords (for administrators)",
                     [file](const SignedIn& by) { return exportAll(by, *file); })
      ->add_option("FILE", *file, "File to write")
      ->required()
      ->check(notEmpty());
  addClassExport(exports, outcome, "csv", "Write the attempts of a class with their metrics, one attempt in each line",
                 writeAttempts);
  const auto [grades, g] = addClassExport(
      exports, outcome, "grades", "Write the share of levels that each person has mastered, for Moodle", writeGrades);
  grades->add_option("--item", g->item, "Name of the graded activity")->capture_default_str();
  grades->add_option("--by", g->key, "Way in which Moodle identifies people: email or name")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, GradeKey>{{"email", GradeKey::Email}, {"name", GradeKey::Name}}));
  const auto [xapi, x] = addClassExport(exports, outcome, "xapi",
                                        "Write the attempts of a class as xAPI 1.0.3 statements", writeStatements);
  xapi->add_option("--home", x->site.homePage, "Web address of your institution, such as https://training.example.org")
      ->required();
  xapi->add_flag("--by-mail", x->site.byMail, "Identify people by their e-mail addresses");
}

}  // namespace insonate::cli
