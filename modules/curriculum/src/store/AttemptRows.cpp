#include "store/AttemptRows.h"

#include "store/MetricsText.h"
#include "store/Names.h"
#include "store/OpeningRows.h"

namespace insonate::store {

AttemptState stateOfEnd(const Row& row) {
  return stateNamed(row.text(10));
}

AttemptFacts factsOf(const Row& row) {
  return {.id = row.text(1),
          .person = row.text(2),
          .curriculum = row.text(3),
          .curriculumVersion = row.count(4),
          .level = row.text(5),
          .procedure = row.text(6),
          .procedureVersion = row.count(7),
          .caseName = row.text(8),
          .begun_us = row.number(9),
          .length_us = row.number(12),
          .state = row.isNull(17) ? stateOfEnd(row) : AttemptState::Voided,
          .succeeded = row.truth(13),
          .criticalErrors = row.count(14),
          .points = row.real(15),
          .metrics = metricsOf(row.text(16)),
          .proof = proofNamed(row.text(18)),
          .testConditions = sittingNamed(row.text(19))};
}

StoredAttempt storedAttemptOf(const Row& row) {
  StoredAttempt kept{
      .facts = factsOf(row), .arrival = row.number(0), .crashed = row.truth(11), .voidReason = row.text(24)};
  kept.facts.caseHash = row.text(20);
  kept.facts.workstation = row.text(21);
  kept.facts.recording = row.text(22);
  kept.facts.recordingHash = row.text(23);
  kept.facts.handsHash = row.text(25);
  return kept;
}

std::vector<AttemptFacts> allFacts(const std::vector<Row>& rows) {
  std::vector<AttemptFacts> facts;
  facts.reserve(rows.size());
  for (const Row& row : rows) facts.push_back(store::factsOf(row));
  return facts;
}

std::vector<AttemptFacts> historyOf(Transaction& transaction, const std::string& person) {
  return allFacts(
      transaction.rows("SELECT " INSONATE_HISTORY_COLUMNS " FROM attempts WHERE person = ? ORDER BY arrival", person));
}

std::optional<StoredAttempt> findAttempt(Transaction& transaction, const std::string& id) {
  const auto row = transaction.row("SELECT " INSONATE_ATTEMPT_COLUMNS " FROM attempts WHERE id = ?", id);
  return row ? std::optional(storedAttemptOf(*row)) : std::nullopt;
}

void insertAttempt(Transaction& transaction, const AttemptFacts& facts, const std::string& run) {
  transaction.run(
      "INSERT INTO attempts SELECT COALESCE(MAX(arrival), 0) + 1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 'open', 0, 0, 0, "
      "0, NULL, '[]', '', '', NULL, NULL, NULL, ? FROM attempts",
      facts.id, facts.person, run, facts.curriculum, facts.curriculumVersion, facts.level, facts.procedure,
      facts.procedureVersion, facts.caseName, facts.caseHash, facts.workstation, facts.begun_us,
      nameOf(facts.testConditions));
}

void endAttempt(Transaction& transaction, const AttemptFacts& facts, bool crashed) {
  transaction.run(
      "UPDATE attempts SET state = ?, crashed = ?, length_us = ?, succeeded = ?, critical_errors = ?, points = ?, "
      "metrics = ?, recording = ?, recording_hash = ? WHERE id = ?",
      nameOf(facts.state), crashed, facts.length_us, facts.succeeded, facts.criticalErrors, facts.points,
      metricsText(facts.metrics), facts.recording, facts.recordingHash, facts.id);
}

}  // namespace insonate::store
