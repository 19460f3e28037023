#include "CsvTables.h"

#include "../class/ClassWords.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Csv.h>

#include <QDateTime>
#include <span>

namespace insonate::review {
namespace {

std::string isoOf(std::int64_t time_us) {
  return QDateTime::fromMSecsSinceEpoch(time_us / 1000, Qt::UTC).toString(Qt::ISODate).toStdString();
}

}  // namespace

std::string classCsv(const ClassController& controller) {
  const auto& book = MetricCatalog::instance();
  std::vector<std::vector<std::string>> rows{{"id", "name", "full name", "email", "level", "level title",
                                              "levels mastered", "needs", "why", "attempts", "last attempt (UTC)"}};
  for (std::size_t i = 0; i < book.comparableCount(); ++i)
    rows[0].push_back(titleWithUnit(book.all()[i]).toStdString());
  for (const Member& member : controller.facts()->learners) {
    const Standing standing = member.standing.value_or(Standing{});
    std::vector<std::string> row{
        member.person.id,
        member.person.name,
        member.person.fullName,
        member.person.email,
        standing.level,
        standing.level.empty() ? std::string() : levelTitle(controller.curriculum(), standing.level).toStdString(),
        member.standing ? std::to_string(standing.mastered) : "",
        attentionWords(*controller.facts(), member).toStdString(),
        standing.sentence,
        std::to_string(member.attempts),
        member.lastAttempt_us ? isoOf(*member.lastAttempt_us) : ""};
    const auto cells = controller.heat().find(member.person.id);
    for (std::size_t i = 0; i < book.comparableCount(); ++i)
      row.push_back(cells == controller.heat().end() ? "" : csvNumber(cells->second[i].value));
    rows.push_back(std::move(row));
  }
  return csvText(rows);
}

std::string attemptsCsv(const PersonFacts& facts) {
  const std::span metrics =
      std::span(MetricCatalog::instance().all()).subspan(1);  // the points have a column of their own
  const Curriculum* curriculum = facts.curriculum ? &*facts.curriculum : nullptr;
  std::vector<std::vector<std::string>> rows{attemptColumns()};
  rows[0].emplace_back("outcome");
  for (const MetricMeaning& meaning : metrics) rows[0].push_back(titleWithUnit(meaning).toStdString());
  for (const AttemptFacts& one : facts.history) {
    std::vector<std::string> row = attemptRow(one, curriculum);
    row.push_back(outcomeOf(one, curriculum).toStdString());
    for (const MetricMeaning& meaning : metrics) row.push_back(csvNumber(valueIn(one, meaning)));
    rows.push_back(std::move(row));
  }
  return csvText(rows);
}

}  // namespace insonate::review
