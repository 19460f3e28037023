#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/teaching/ClassExports.h>
#include <insonate/teaching/TeachingHere.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace insonate {
namespace {

using TakeTrainee = std::function<Result<void>(const Person&, const std::vector<AttemptFacts>&)>;

/// Calls `take` for each trainee of a class, with all attempts.
Result<void> eachTrainee(const SignedIn& by, const Cohort& cohort, const TakeTrainee& take) {
  const auto members = CohortStore(by).members(cohort.id);
  if (!members) return tl::unexpected(members.error());
  for (const Member& member : *members) {
    if (member.teaches) continue;
    const auto attempts = AttemptStore(by).history(member.person.id);
    if (!attempts) return tl::unexpected(attempts.error());
    if (auto taken = take(member.person, *attempts); !taken) return taken;
  }
  return {};
}

}  // namespace

Result<AttemptsExport> exportAttempts(const SignedIn& by, const Cohort& cohort, const Curriculum* curriculum) {
  const auto metrics = metricMeanings();
  std::vector<std::vector<std::string>> rows{attemptColumns()};
  rows[0].insert(rows[0].begin() + 1, {"name", "full name"});
  for (const MetricMeaning& metric : metrics) rows[0].push_back(metric.id);
  const auto done = eachTrainee(by, cohort, [&](const Person& person, const std::vector<AttemptFacts>& attempts) {
    for (const AttemptFacts& facts : attempts) {
      std::vector<std::string> row = attemptRow(facts, curriculum);
      row.insert(row.begin() + 1, {person.name, person.fullName});
      for (const MetricMeaning& metric : metrics) row.push_back(csvNumber(valueOf(facts, metric.id, metric.version)));
      rows.push_back(std::move(row));
    }
    return Result<void>();
  });
  if (!done) return tl::unexpected(done.error());
  return AttemptsExport{csvText(rows), rows.size() - 1};
}

Result<GradesExport> exportGrades(const SignedIn& by, const Cohort& cohort, const Curriculum& curriculum,
                                  const std::string& item, GradeKey key) {
  const auto members = CohortStore(by).members(cohort.id);
  if (!members) return tl::unexpected(members.error());
  std::vector<std::string> learners;
  for (const Member& member : *members)
    if (!member.teaches) learners.push_back(member.person.id);
  const auto standings = CohortStore(by).standings(cohort.id, learners);
  if (!standings) return tl::unexpected(standings.error());
  std::vector<Grade> grades;
  for (const Member& member : *members) {
    const auto found = standings->find(member.person.id);
    if (found == standings->end()) continue;
    const Standing& standing = found->second;
    Grade grade{.person = member.person, .percent = std::nullopt, .feedback = ""};
    if (member.attempts > 0) grade.percent = 100.0 * standing.mastered / static_cast<double>(curriculum.levels.size());
    if (const Level* level = curriculum.level(standing.level)) grade.feedback = level->title + ": " + standing.sentence;
    grades.push_back(std::move(grade));
  }
  GradesExport made{.book = gradeBook(item, key, grades)};
  made.grades = grades.size() - made.book.leftOut.size();
  return made;
}

Result<XapiExport> exportStatements(const SignedIn& by, const Cohort& cohort, const Curriculum& curriculum,
                                    const XapiSite& site) {
  XapiExport all;
  const auto done =
      eachTrainee(by, cohort, [&](const Person& person, const std::vector<AttemptFacts>& attempts) -> Result<void> {
        auto some = xapiStatements(site, curriculum, person, attempts);
        if (!some) return tl::unexpected(some.error());
        std::ranges::move(some->statements, std::back_inserter(all.statements));
        std::ranges::move(some->leftOut, std::back_inserter(all.leftOut));
        return {};
      });
  if (!done) return tl::unexpected(done.error());
  return all;
}

}  // namespace insonate
