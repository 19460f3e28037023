#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/GradeBook.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/curriculum/XapiStatements.h>
#include <insonate/teaching/TeachingHere.h>

#include <algorithm>
#include <iterator>
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

/// Calls `take` for each who learns in a class, with all their attempts.
Result<Cohort> eachTrainee(const SignedIn& by, const std::string& name,
                           const std::function<Result<void>(const Person&, const std::vector<AttemptFacts>&)>& take) {
  auto cohort = classNamed(by, name);
  if (!cohort) return cohort;
  const auto members = CohortStore(by).members(cohort->id);
  if (!members) return tl::unexpected(members.error());
  for (const Member& member : *members) {
    if (member.teaches) continue;
    const auto attempts = AttemptStore(by).history(member.person.id);
    if (!attempts) return tl::unexpected(attempts.error());
    if (auto taken = take(member.person, *attempts); !taken) return tl::unexpected(taken.error());
  }
  return cohort;
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

/// A line an attempt, a column a metric.
Result<Answer> exportCsv(const SignedIn& by, const ExportArguments& a) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto curriculum = curriculumIfAny(by, *cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto metrics = metricMeanings();
  std::vector<std::vector<std::string>> rows{attemptColumns()};
  rows[0].insert(rows[0].begin() + 1, {"name", "full name"});
  for (const MetricMeaning& metric : metrics) rows[0].push_back(metric.id);
  const auto done = eachTrainee(by, a.className, [&](const Person& person, const std::vector<AttemptFacts>& attempts) {
    for (const AttemptFacts& facts : attempts) {
      std::vector<std::string> row = attemptRow(facts, *curriculum ? &**curriculum : nullptr);
      row.insert(row.begin() + 1, {person.name, person.fullName});
      for (const MetricMeaning& metric : metrics) row.push_back(csvNumber(valueOf(facts, metric.id, metric.version)));
      rows.push_back(std::move(row));
    }
    return Result<void>();
  });
  if (!done) return tl::unexpected(done.error());
  if (auto written = writeAtomically(a.file, csvText(rows)); !written) return tl::unexpected(written.error());
  return wrote(a.file, {{"attempts", rows.size() - 1}});
}

/// "Left out: Bob B (no grade yet), ..."; "" for nobody.
std::string ungradedSentence(const std::vector<UngradedPerson>& leftOut) {
  std::string sentence;
  for (const UngradedPerson& one : leftOut)
    sentence += (sentence.empty() ? " Left out: " : ", ") + one.fullName + " (" + one.why + ")";
  return sentence.empty() ? "" : sentence + ".";
}

/// The share of levels that each has mastered.
Result<Answer> exportGrades(const SignedIn& by, const ExportArguments& a) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto curriculum = curriculumOf(by, *cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto members = CohortStore(by).members(cohort->id);
  if (!members) return tl::unexpected(members.error());
  const auto standings = standingsOf(by, *cohort, *members);
  if (!standings) return tl::unexpected(standings.error());
  std::vector<Grade> grades;
  for (const Member& member : *members) {
    const auto found = standings->find(member.person.id);
    if (found == standings->end()) continue;
    const Standing& standing = found->second;
    Grade grade{.person = member.person, .percent = std::nullopt, .feedback = ""};
    if (member.attempts > 0) grade.percent = 100.0 * standing.mastered / static_cast<double>(curriculum->levels.size());
    if (!standing.level.empty()) grade.feedback = standing.sentence;
    grades.push_back(std::move(grade));
  }
  const GradeBook book = gradeBook(a.item, a.key, grades);
  if (auto written = writeAtomically(a.file, book.csv); !written) return tl::unexpected(written.error());
  Json names = Json::array(), reasons = Json::array();
  for (const UngradedPerson& one : book.leftOut) names.push_back(one.fullName), reasons.push_back(one.why);
  Answer answer = wrote(a.file, {{"grades", grades.size() - book.leftOut.size()},
                                 {"left_out", std::move(names)},
                                 {"left_out_because", std::move(reasons)}});
  answer.text += ungradedSentence(book.leftOut);
  return answer;
}

Result<Answer> exportXapi(const SignedIn& by, const ExportArguments& a) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto curriculum = curriculumOf(by, *cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  XapiExport all;
  const auto done = eachTrainee(by, a.className,
                                [&](const Person& person, const std::vector<AttemptFacts>& attempts) -> Result<void> {
                                  auto some = xapiStatements(a.site, *curriculum, person, attempts);
                                  if (!some) return tl::unexpected(some.error());
                                  std::ranges::move(some->statements, std::back_inserter(all.statements));
                                  std::ranges::move(some->leftOut, std::back_inserter(all.leftOut));
                                  return {};
                                });
  if (!done) return tl::unexpected(done.error());
  if (auto written = writeXapi(a.file, all.statements); !written) return tl::unexpected(written.error());
  Json leftOut = Json::array();
  for (const LeftOutAttempt& one : all.leftOut) leftOut.push_back({{"id", one.attempt}, {"why", one.why}});
  Answer answer = wrote(a.file, {{"statements", all.statements.size()}, {"left_out", std::move(leftOut)}});
  if (!all.leftOut.empty()) answer.text += " " + leftOutSentence(all.leftOut);
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
  addSignedInCommand(exports, outcome, "json", "All data except passwords (administrators)",
                     [file](const SignedIn& by) { return exportAll(by, *file); })
      ->add_option("FILE", *file, "File to write")
      ->required()
      ->check(notEmpty());
  addClassExport(exports, outcome, "csv", "The attempts of a class with their metrics, one in each line", exportCsv);
  const auto [grades, g] = addClassExport(exports, outcome, "grades",
                                          "Share of levels that each person has mastered, for Moodle", exportGrades);
  grades->add_option("--item", g->item, "Name of the graded activity")->capture_default_str();
  grades->add_option("--by", g->key, "How Moodle identifies people: email or name")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, GradeKey>{{"email", GradeKey::Email}, {"name", GradeKey::Name}}));
  const auto [xapi, x] =
      addClassExport(exports, outcome, "xapi", "A class's attempts as xAPI 1.0.3 statements", exportXapi);
  xapi->add_option("--home", x->site.homePage, "Address of your site: https://training.example.org")->required();
  xapi->add_flag("--by-mail", x->site.byMail, "Identify people by their e-mail addresses");
}

}  // namespace insonate::cli
