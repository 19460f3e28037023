#include "store/Export.h"

#include "store/AttemptRows.h"
#include "store/JsonRows.h"

#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Judgement.h>

#include <nlohmann/json.hpp>

#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate::store {
namespace {

struct Table {
  const char* name;
  std::vector<const char*> columns;
  std::string_view all;  ///< these columns of all rows
};

const std::vector<Table>& tables() {
  static const std::vector<Table> kTables{
      {"people",
       {"id", "name", "full_name", "email", "role", "disabled"},
       "SELECT id, name, full_name, email, role, disabled FROM people ORDER BY id"},
      {"erasures",
       {"person", "erased_us", "erased_by"},
       "SELECT person, erased_us, erased_by FROM erasures ORDER BY person"},
      {"cohorts",
       {"id", "name", "curriculum", "curriculum_version", "archived"},
       "SELECT id, name, curriculum, curriculum_version, archived FROM cohorts ORDER BY id"},
      {"memberships",
       {"cohort", "person", "teaches"},
       "SELECT cohort, person, teaches FROM memberships ORDER BY cohort, person"},
      {"curricula",
       {"name", "version", "text", "hash", "published_us", "published_by"},
       "SELECT name, version, text, hash, published_us, published_by FROM curricula ORDER BY name, version"},
      {"attempts",
       {"arrival",
        "id",
        "person",
        "curriculum",
        "curriculum_version",
        "level",
        "procedure",
        "procedure_version",
        "case_name",
        "case_hash",
        "workstation",
        "begun_us",
        "state",
        "crashed",
        "length_us",
        "succeeded",
        "critical_errors",
        "points",
        "metrics",
        "recording",
        "recording_hash",
        "voided_us",
        "voided_by",
        "void_reason",
        "sitting"},
       "SELECT arrival, id, person, curriculum, curriculum_version, level, procedure, procedure_version, case_name, "
       "case_hash, workstation, begun_us, state, crashed, length_us, succeeded, critical_errors, points, metrics, "
       "recording, recording_hash, voided_us, voided_by, void_reason, sitting FROM attempts ORDER BY arrival"},
      {"hands", {"hash", "attempt", "since_us"}, "SELECT hash, attempt, since_us FROM hands ORDER BY hash"},
      {"proofs",
       {"attempt", "state", "accepted_by"},
       "SELECT attempt, state, accepted_by FROM proofs ORDER BY attempt"},
      {"forms",
       {"arrival", "id", "form", "form_version", "person", "attempt", "filled_by", "filled_us", "answers"},
       "SELECT arrival, id, form, form_version, person, attempt, filled_by, filled_us, answers FROM forms ORDER BY "
       "arrival"},
      {"comments",
       {"id", "attempt", "at_us", "author", "written_us", "text", "read_us", "removed_us", "removed_by"},
       "SELECT id, attempt, at_us, author, written_us, text, read_us, removed_us, removed_by FROM comments ORDER BY "
       "attempt, at_us, id"},
      {"openings",
       {"id", "cohort", "curriculum", "level", "start_us", "end_us", "has_code", "opened_by", "opened_us", "closed_by",
        "closed_us"},
       "SELECT id, cohort, curriculum, level, start_us, end_us, CASE WHEN code = '' THEN 0 ELSE 1 END, opened_by, "
       "opened_us, closed_by, closed_us FROM openings ORDER BY opened_us, id"},
      {"opening_entries",
       {"opening", "person", "entered_us"},
       "SELECT opening, person, entered_us FROM opening_entries ORDER BY opening, person"},
      {"audit",
       {"number", "time_us", "actor", "workstation", "act", "person", "detail", "allowed", "hash"},
       "SELECT number, time_us, actor, workstation, act, person, detail, allowed, hash FROM audit ORDER BY number"}};
  return kTables;
}

using Version = std::pair<std::string, int>;

/// Returns the curricula that can be parsed; a later version of the program may have stored texts that this one does
/// not know.
std::map<Version, Curriculum> curriculaOf(Transaction& transaction) {
  std::map<Version, Curriculum> curricula;
  for (const Row& row : transaction.rows("SELECT name, version, text FROM curricula"))
    if (auto curriculum = parseCurriculum(row.text(2)))
      curricula.emplace(Version{row.text(0), row.count(1)}, std::move(*curriculum));
  return curricula;
}

/// Adds whether each attempt passed and with which assistance, by the version of the curriculum for which it was made;
/// null in free practice.
void addJudgements(Transaction& transaction, nlohmann::ordered_json& attempts) {
  const auto curricula = curriculaOf(transaction);
  std::size_t at = 0;
  for (const Row& row : transaction.rows("SELECT " INSONATE_HISTORY_COLUMNS " FROM attempts ORDER BY arrival")) {
    const AttemptFacts facts = factsOf(row);
    nlohmann::ordered_json& entry = attempts[at++];
    entry["voided"] = facts.state == AttemptState::Voided;
    entry["broke_off"] = hasBrokenOff(facts);
    entry["assistance"] = nullptr, entry["passed"] = nullptr;
    const auto curriculum = curricula.find({facts.curriculum, facts.curriculumVersion});
    if (curriculum == curricula.end()) continue;
    if (const Level* level = levelOf(curriculum->second, facts)) entry["assistance"] = nameOf(level->assistance);
    if (const auto passed = passedIn(curriculum->second, facts)) entry["passed"] = *passed;
  }
}

}  // namespace

std::string exported(Transaction& transaction) {
  nlohmann::ordered_json json;
  json["schema"] = transaction.number("SELECT MAX(number) FROM schema_migrations");
  for (const Table& table : tables()) json[table.name] = jsonRows(table.columns, transaction.rows(table.all));
  addJudgements(transaction, json["attempts"]);
  return json.dump();
}

}  // namespace insonate::store
