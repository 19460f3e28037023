#include "store/StandingRows.h"

#include "store/AttemptRows.h"
#include "store/CurriculumRows.h"

#include <array>
#include <string_view>
#include <utility>

namespace insonate::store {
namespace {

constexpr std::array<std::pair<Concern, std::string_view>, 3> kConcerns{
    {{Concern::None, ""}, {Concern::Slipped, "slipped"}, {Concern::Stuck, "stuck"}}};

Concern concernNamed(const std::string& name) {
  for (const auto& [concern, word] : kConcerns)
    if (word == name) return concern;
  return Concern::None;
}

std::string_view concernName(Concern concern) {
  for (const auto& [known, word] : kConcerns)
    if (known == concern) return word;
  return {};
}

std::int64_t changesOf(Transaction& transaction, const std::string& person) {
  return transaction.number("SELECT " INSONATE_CHANGES " FROM attempts WHERE person = ?", person);
}

Standing workOut(const Curriculum& curriculum, const std::vector<AttemptFacts>& history, std::int64_t changes,
                 std::int64_t now_us) {
  return computeStanding(curriculum, history, computeProgress(curriculum, history, now_us), now_us, changes);
}

void keep(Transaction& transaction, const std::string& person, const Standing& standing) {
  transaction.run("DELETE FROM standings WHERE person = ? AND curriculum = ? AND curriculum_version = ?", person,
                  standing.curriculum, standing.curriculumVersion);
  transaction.run("INSERT INTO standings VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", person, standing.curriculum,
                  standing.curriculumVersion, standing.level, standing.mastered,
                  std::string(concernName(standing.concern)), standing.sentence, standing.changes, standing.from_us,
                  standing.until_us, kStandingRules);
}

}  // namespace

Standing standingFrom(const Row& row, std::size_t column) {
  return {.curriculum = row.text(column),
          .curriculumVersion = row.count(column + 1),
          .level = row.text(column + 2),
          .mastered = row.count(column + 3),
          .concern = concernNamed(row.text(column + 4)),
          .sentence = row.text(column + 5),
          .changes = row.number(column + 6),
          .from_us = row.number(column + 7),
          .until_us = row.number(column + 8)};
}

bool isCurrent(const Row& row, std::size_t column, std::int64_t changes, std::int64_t now_us) {
  const Standing kept = standingFrom(row, column);
  return row.count(column + 9) == kStandingRules && kept.changes == changes && kept.from_us <= now_us &&
         now_us < kept.until_us;
}

Standing currentStanding(Transaction& transaction, const std::string& person, const Curriculum& curriculum,
                         std::int64_t now_us) {
  const std::int64_t changes = changesOf(transaction, person);
  const auto kept = transaction.row("SELECT " INSONATE_STANDING_COLUMNS
                                    " FROM standings WHERE person = ? AND curriculum = ? AND curriculum_version = ?",
                                    person, curriculum.name, curriculum.version);
  if (kept && isCurrent(*kept, 0, changes, now_us)) return standingFrom(*kept, 0);
  const Standing standing = workOut(curriculum, historyOf(transaction, person), changes, now_us);
  keep(transaction, person, standing);
  return standing;
}

void renewStandings(Transaction& transaction, const std::string& person, std::int64_t now_us) {
  const auto taught = transaction.rows(
      "SELECT DISTINCT curriculum, curriculum_version FROM memberships JOIN cohorts ON cohorts.id = memberships.cohort "
      "WHERE person = ? AND teaches = 0 AND curriculum <> ''",
      person);
  if (taught.empty()) return;
  const std::int64_t changes = changesOf(transaction, person);
  const auto history = historyOf(transaction, person);
  for (const Row& row : taught)
    if (const auto curriculum = publishedCurriculum(transaction, row.text(0), row.count(1)); curriculum)
      keep(transaction, person, workOut(*curriculum, history, changes, now_us));
}

}  // namespace insonate::store
