#include "store/PersonRows.h"

#include "store/AttemptRows.h"
#include "store/CurriculumRows.h"
#include "store/JsonRows.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/Judgement.h>

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate::store {
namespace {

struct PersonTable {
  const char* name;
  std::vector<const char*> columns;
  std::string_view rows;  ///< these columns of the person's rows; its only parameter is the person's id
};

std::vector<PersonTable> accountTables() {
  return {
      {"account",
       {"id", "name", "full_name", "email", "role", "disabled", "must_change_password"},
       "SELECT people.id, name, full_name, email, role, disabled, must_change FROM people JOIN credentials ON person = "
       "people.id WHERE people.id = ?"},
      {"classes",
       {"id", "name", "archived", "teaches", "curriculum", "curriculum_version"},
       "SELECT id, name, archived, teaches, curriculum, curriculum_version FROM memberships JOIN cohorts ON id = "
       "cohort "
       "WHERE person = ? ORDER BY name_key"},
      {"browser_sessions",
       {"begun_us", "used_us"},
       "SELECT begun_us, used_us FROM browser_sessions WHERE person = ? ORDER BY begun_us"},
      {"sign_in_tokens", {"made_us"}, "SELECT made_us FROM sign_in_tokens WHERE person = ? ORDER BY made_us"},
      {"workstations_used",
       {"workstation", "since_us"},
       "SELECT workstation, since_us FROM workstation_people WHERE person = ? ORDER BY workstation"},
      {"workstations_added",
       {"name", "added_us", "revoked_us"},
       "SELECT name, added_us, revoked_us FROM workstations WHERE added_by = ? ORDER BY name"}};
}

std::vector<PersonTable> trainingTables() {
  return {
      {"attempts",
       {"arrival",   "id",          "curriculum",        "curriculum_version",
        "level",     "procedure",   "procedure_version", "case_name",
        "case_hash", "workstation", "begun_us",          "state",
        "crashed",   "length_us",   "succeeded",         "critical_errors",
        "points",    "metrics",     "recording",         "recording_hash",
        "voided_us", "voided_by",   "void_reason",       "sitting",
        "proof",     "hands_hash"},
       "SELECT arrival, id, curriculum, curriculum_version, level, procedure, procedure_version, case_name, case_hash, "
       "workstation, begun_us, state, crashed, length_us, succeeded, critical_errors, points, metrics, recording, "
       "recording_hash, voided_us, voided_by, void_reason, sitting, " INSONATE_PROOF_COLUMN
       ", (SELECT MIN(hash) FROM hands WHERE attempt = attempts.id) FROM attempts WHERE person = ? ORDER BY arrival"},
      {"standings",
       {"curriculum", "curriculum_version", "level", "mastered", "concern", "sentence", "from_us", "until_us"},
       "SELECT curriculum, curriculum_version, level, mastered, concern, sentence, from_us, until_us FROM standings "
       "WHERE person = ? ORDER BY curriculum, curriculum_version"},
      {"comments",
       {"id", "attempt", "at_us", "author_name", "written_us", "text", "read_us", "removed_us"},
       "SELECT comments.id, attempt, at_us, COALESCE(NULLIF(full_name, ''), name, author), written_us, text, read_us, "
       "removed_us FROM comments JOIN attempts ON attempts.id = attempt LEFT JOIN people ON people.id = author WHERE "
       "attempts.person = ? ORDER BY attempts.arrival, at_us, comments.id"},
      {"forms",
       {"id", "form", "form_version", "attempt", "rater_name", "filled_us", "answers"},
       "SELECT forms.id, form, form_version, attempt, COALESCE(NULLIF(full_name, ''), name), filled_us, answers FROM "
       "forms JOIN people ON people.id = filled_by WHERE person = ? ORDER BY arrival"},
      {"test_codes_entered",
       {"opening", "curriculum", "level", "entered_us"},
       "SELECT opening, curriculum, level, entered_us FROM opening_entries JOIN openings ON id = opening WHERE person "
       "= "
       "? ORDER BY entered_us"},
      {"videos",
       {"attempt", "asked_us", "begun_us", "ended_us"},
       "SELECT attempt, asked_us, videos.begun_us, ended_us FROM videos JOIN attempts ON id = attempt WHERE person = ? "
       "ORDER "
       "BY asked_us"},
      {"verifications",
       {"attempt", "since_us", "received_us", "ended_us", "why"},
       "SELECT attempt, since_us, received_us, ended_us, why FROM verifications JOIN attempts ON id = attempt WHERE "
       "person = ? ORDER BY since_us"}};
}

/// Rows that the person made about the training of others.
std::vector<PersonTable> teachingTables() {
  return {
      {"comments_written",
       {"id", "attempt", "at_us", "written_us", "text", "removed_us"},
       "SELECT id, attempt, at_us, written_us, text, removed_us FROM comments WHERE author = ? ORDER BY written_us, "
       "id"},
      {"forms_about_others",
       {"id", "form", "form_version", "person", "attempt", "filled_us", "answers"},
       "SELECT id, form, form_version, person, attempt, filled_us, answers FROM forms WHERE filled_by = ? AND person "
       "<> "
       "filled_by ORDER BY arrival"},
      {"attempts_voided",
       {"attempt", "voided_us", "void_reason"},
       "SELECT id, voided_us, void_reason FROM attempts WHERE voided_by = ? ORDER BY voided_us, arrival"},
      {"attempts_accepted", {"attempt"}, "SELECT attempt FROM proofs WHERE accepted_by = ? ORDER BY attempt"},
      {"tests_opened",
       {"id", "cohort", "curriculum", "level", "start_us", "end_us", "opened_us"},
       "SELECT id, cohort, curriculum, level, start_us, end_us, opened_us FROM openings WHERE opened_by = ? ORDER BY "
       "opened_us, id"},
      {"tests_closed",
       {"id", "closed_us"},
       "SELECT id, closed_us FROM openings WHERE closed_by = ? ORDER BY closed_us, id"},
      {"curricula_published",
       {"name", "version", "published_us"},
       "SELECT name, version, published_us FROM curricula WHERE published_by = ? ORDER BY name, version"},
      // The detail of an entry about others contains data of these others.
      {"audit",
       {"number", "time_us", "actor", "workstation", "act", "person", "detail", "allowed"},
       "SELECT number, time_us, actor, workstation, act, audit.person, CASE WHEN audit.person = own.id THEN detail "
       "ELSE "
       "'' END, allowed FROM people AS own JOIN audit ON actor = own.id OR audit.person = own.id OR detail LIKE '%' || "
       "own.id || '%' WHERE own.id = ? ORDER BY number"}};
}

/// Versions of curricula that cannot be read have no entry.
class CurriculaByVersion {
 public:
  explicit CurriculaByVersion(Transaction& transaction) : transaction_(transaction) {}
  const Curriculum* of(const AttemptFacts& facts) {
    if (facts.curriculum.empty()) return nullptr;
    auto [place, isNew] = known_.try_emplace({facts.curriculum, facts.curriculumVersion});
    if (isNew)
      if (auto found = publishedCurriculum(transaction_, facts.curriculum, facts.curriculumVersion))
        place->second = std::move(*found);
    return place->second ? &*place->second : nullptr;
  }

 private:
  Transaction& transaction_;
  std::map<std::pair<std::string, int>, std::optional<Curriculum>> known_;
};

}  // namespace

nlohmann::ordered_json rowsOfPerson(Transaction& transaction, const std::string& person) {
  nlohmann::ordered_json json;
  for (const auto& tables : {accountTables(), trainingTables(), teachingTables()})
    for (const PersonTable& table : tables)
      json[table.name] = jsonRows(table.columns, transaction.rows(table.rows, person));
  return json;
}

std::string attemptsOfPerson(Transaction& transaction, const std::string& person) {
  const std::vector<AttemptFacts> history = historyOf(transaction, person);
  std::set<std::pair<std::string, int>> metrics;
  for (const AttemptFacts& facts : history)
    for (const auto& metric : facts.metrics) metrics.emplace(metric.id, metric.version);
  std::vector<std::vector<std::string>> rows{attemptColumns()};
  for (const auto& [id, version] : metrics) rows[0].push_back(id + ", version " + std::to_string(version));
  CurriculaByVersion curricula(transaction);
  for (const AttemptFacts& facts : history) {
    std::vector<std::string> row = attemptRow(facts, curricula.of(facts));
    for (const auto& [id, version] : metrics) row.push_back(csvNumber(valueOf(facts, id, version)));
    rows.push_back(std::move(row));
  }
  return csvText(rows);
}

}  // namespace insonate::store
