#include "store/Export.h"

#include <nlohmann/json.hpp>

#include <string_view>
#include <vector>

namespace insonate::store {
namespace {

struct Table {
  const char* name;
  std::vector<const char*> columns;
  std::string_view all;  ///< those columns of all rows
};

const std::vector<Table>& tables() {
  static const std::vector<Table> kTables{
      {"people",
       {"id", "name", "full_name", "email", "role", "disabled"},
       "SELECT id, name, full_name, email, role, disabled FROM people ORDER BY id"},
      {"cohorts",
       {"id", "name", "curriculum", "curriculum_version"},
       "SELECT id, name, curriculum, curriculum_version FROM cohorts ORDER BY id"},
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
        "void_reason"},
       "SELECT arrival, id, person, curriculum, curriculum_version, level, procedure, procedure_version, case_name, "
       "case_hash, workstation, begun_us, state, crashed, length_us, succeeded, critical_errors, points, metrics, "
       "recording, recording_hash, voided_us, voided_by, void_reason FROM attempts ORDER BY arrival"},
      {"hands", {"hash", "attempt", "since_us"}, "SELECT hash, attempt, since_us FROM hands ORDER BY hash"},
      {"proofs",
       {"attempt", "state", "accepted_by"},
       "SELECT attempt, state, accepted_by FROM proofs ORDER BY attempt"},
      {"forms",
       {"arrival", "id", "form", "form_version", "person", "attempt", "filled_by", "filled_us", "answers"},
       "SELECT arrival, id, form, form_version, person, attempt, filled_by, filled_us, answers FROM forms ORDER BY "
       "arrival"},
      {"audit",
       {"number", "time_us", "actor", "workstation", "act", "person", "detail", "allowed", "hash"},
       "SELECT number, time_us, actor, workstation, act, person, detail, allowed, hash FROM audit ORDER BY number"}};
  return kTables;
}

nlohmann::ordered_json jsonOf(const std::string_view column, const Row& row, std::size_t at) {
  if (row.isNull(at)) return nullptr;
  // Kept as texts, read as what they are.
  if (column == "metrics" || column == "answers") return nlohmann::ordered_json::parse(row.text(at), nullptr, false);
  switch (row.value(at).type()) {
    case QVariant::Int:
    case QVariant::LongLong:
      return row.number(at);
    case QVariant::Double:
      return *row.real(at);
    default:
      return row.text(at);
  }
}

}  // namespace

std::string exported(Transaction& transaction) {
  nlohmann::ordered_json json;
  json["schema"] = transaction.number("SELECT MAX(number) FROM schema_migrations");
  for (const Table& table : tables()) {
    nlohmann::ordered_json& list = json[table.name] = nlohmann::ordered_json::array();
    for (const Row& row : transaction.rows(table.all)) {
      nlohmann::ordered_json entry;
      for (std::size_t i = 0; i < table.columns.size(); ++i) entry[table.columns[i]] = jsonOf(table.columns[i], row, i);
      list.push_back(std::move(entry));
    }
  }
  return json.dump();
}

}  // namespace insonate::store
