#include "store/CommentRows.h"
#include "store/CurriculumRows.h"
#include "store/OpeningRows.h"
#include "store/Proofs.h"
#include "store/StandingRows.h"
#include "store/site/Down.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace insonate::store {
namespace {

/// Rows as texts, keyed by the first column.
using Rows = std::map<std::string, std::vector<std::string>>;

/// People with their passwords.
constexpr std::string_view kPeople =
    "SELECT id, name, name_key, full_name, email, role, disabled, password, must_change, version FROM people "
    "JOIN credentials ON person = id";
constexpr std::string_view kCohorts = "SELECT id, name, name_key, curriculum, curriculum_version FROM cohorts";
constexpr std::string_view kMemberships = "SELECT cohort || ' ' || person, cohort, person, teaches FROM memberships";

struct Taught {
  Rows people{}, cohorts{}, memberships{};
  std::vector<KeptCurriculum> curricula{};
  std::vector<Row> voided{}, accepted{}, comments{}, openings{};
};

Rows rowsByKey(Transaction& transaction, std::string_view sql) {
  Rows rows;
  for (const Row& row : transaction.rows(sql)) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < row.size(); ++i) texts.push_back(row.text(i));
    rows[row.text(0)] = std::move(texts);
  }
  return rows;
}

Result<Taught> readServer(Core& server, const std::string& workstation) {
  return inTransaction(server, Way::Read, [&](Transaction& transaction) -> Result<Taught> {
    Taught taught{rowsByKey(transaction, kPeople), rowsByKey(transaction, kCohorts),
                  rowsByKey(transaction, kMemberships)};
    for (const CurriculumEntry& entry : listCurricula(transaction))
      if (auto kept = findCurriculum(transaction, entry.name, entry.version))
        taught.curricula.push_back(std::move(*kept));
    taught.voided = transaction.rows(
        "SELECT id, voided_us, voided_by, void_reason FROM attempts WHERE workstation = ? AND voided_us IS NOT NULL",
        workstation);
    taught.accepted = transaction.rows(
        "SELECT attempt, accepted_by FROM proofs JOIN attempts ON attempts.id = attempt WHERE workstation = ? AND "
        "proofs.state = 'accepted'",
        workstation);
    taught.comments = transaction.rows(
        "SELECT " INSONATE_COMMENT_COLUMNS
        " FROM comments JOIN attempts ON attempts.id = attempt WHERE workstation = ? ORDER BY comments.id",
        workstation);
    taught.openings = transaction.rows("SELECT " INSONATE_OPENING_COLUMNS " FROM openings ORDER BY id");
    return taught;
  });
}

/// Returns the rows of the server that are new here or differ.
std::vector<std::vector<std::string>> changed(const Rows& server, const Rows& here) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [key, row] : server)
    if (const auto own = here.find(key); own == here.end() || own->second != row) rows.push_back(row);
  return rows;
}

std::int64_t numberIn(const std::string& text) {
  return std::stoll(text);
}

int takePeople(Transaction& here, const Rows& server) {
  Rows own = rowsByKey(here, kPeople);
  // A password that was changed here and has not been sent is newer than the server's.
  std::set<std::string> unsent;
  for (const Row& row : here.rows("SELECT id FROM outbox WHERE kind = 'password'")) unsent.insert(row.text(0));
  const auto rows = changed(server, own);
  // Two people may have exchanged names: existing names are cleared before new ones are assigned.
  for (const auto& row : rows) here.run("UPDATE people SET name_key = id WHERE id = ?", row[0]);
  for (const auto& row : rows) {
    here.run(
        "INSERT INTO people VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT (id) DO UPDATE SET name = excluded.name, "
        "name_key = excluded.name_key, full_name = excluded.full_name, email = excluded.email, "
        "role = excluded.role, disabled = excluded.disabled",
        row[0], row[1], row[2], row[3], row[4], row[5], numberIn(row[6]));
    if (!unsent.contains(row[0]))
      here.run(
          "INSERT INTO credentials VALUES (?, ?, ?, ?) ON CONFLICT (person) DO UPDATE SET password = "
          "excluded.password, "
          "must_change = excluded.must_change, version = excluded.version",
          row[0], row[7], numberIn(row[8]), numberIn(row[9]));
  }
  return static_cast<int>(rows.size());
}

int takeCohorts(Transaction& here, const Taught& server) {
  const Rows own = rowsByKey(here, kCohorts), ownMembers = rowsByKey(here, kMemberships);
  for (const auto& [key, row] : ownMembers)
    if (!server.memberships.contains(key))
      here.run("DELETE FROM memberships WHERE cohort = ? AND person = ?", row[1], row[2]);
  for (const auto& [key, row] : own)
    if (!server.cohorts.contains(key)) here.run("DELETE FROM cohorts WHERE id = ?", key);
  const auto rows = changed(server.cohorts, own);
  for (const auto& row : rows) here.run("UPDATE cohorts SET name_key = id WHERE id = ?", row[0]);
  for (const auto& row : rows)
    here.run(
        "INSERT INTO cohorts VALUES (?, ?, ?, ?, ?) ON CONFLICT (id) DO UPDATE SET name = excluded.name, "
        "name_key = excluded.name_key, curriculum = excluded.curriculum, curriculum_version = "
        "excluded.curriculum_version",
        row[0], row[1], row[2], row[3], numberIn(row[4]));
  for (const auto& row : changed(server.memberships, ownMembers))
    here.run(
        "INSERT INTO memberships VALUES (?, ?, ?) ON CONFLICT (cohort, person) DO UPDATE SET teaches = "
        "excluded.teaches",
        row[1], row[2], numberIn(row[3]));
  return static_cast<int>(rows.size());
}

int takeCurricula(Transaction& here, const std::vector<KeptCurriculum>& server, std::vector<std::string>& troubles) {
  int taken = 0;
  for (const KeptCurriculum& theirs : server) {
    const std::string name = "Version " + std::to_string(theirs.entry.version) + " of '" + theirs.entry.name + "'";
    const auto own = findCurriculum(here, theirs.entry.name, theirs.entry.version);
    if (!checkHash(theirs)) {
      troubles.push_back(name + " is damaged on the server and was not copied. Publish it there as a later version.");
    } else if (!own) {
      insertCurriculum(here, theirs);
      ++taken;
    } else if (own->entry.hash != theirs.entry.hash) {
      troubles.push_back(
          name +
          " differs between the server and this computer. Publish the right one on the server as a later version.");
    }
  }
  return taken;
}

/// Voids here what instructors voided on the server, for attempts made here.
void takeVoided(Transaction& here, const std::vector<Row>& voided) {
  for (const Row& row : voided)
    here.run(
        "UPDATE attempts SET voided_us = ?, voided_by = ?, void_reason = ? WHERE id = ? AND voided_us IS NULL AND "
        "state <> 'open'",
        row.number(1), row.text(2), row.text(3), row.text(0));
}

/// Openings that were made here before the workstation belonged to the server end.
void takeOpenings(Transaction& here, const std::vector<Row>& openings, std::int64_t now_us) {
  std::set<std::string> known;
  for (const Row& row : openings) {
    mergeOpening(here, row);
    known.insert(row.text(0));
  }
  for (const Row& row : here.rows("SELECT id, opened_by FROM openings WHERE closed_us IS NULL"))
    if (!known.contains(row.text(0)))
      here.run("UPDATE openings SET closed_us = ?, closed_by = ? WHERE id = ?", now_us, row.text(1), row.text(0));
}

/// Applies the server's acceptances of attempts of this workstation.
void takeAccepted(Transaction& here, const std::vector<Row>& accepted, std::int64_t now_us) {
  for (const Row& row : accepted) {
    const auto person = here.row(
        "SELECT person FROM attempts JOIN proofs ON attempt = attempts.id WHERE attempts.id = ? AND proofs.state = "
        "'unproven'",
        row.text(0));
    if (!person) continue;
    acceptAttempt(here, row.text(0), row.text(1));
    here.run("DELETE FROM standings WHERE person = ?", person->text(0));
    renewStandings(here, person->text(0), now_us);
  }
}

}  // namespace

Result<void> fetchFromServer(Core& here, Core& server, UploadReport& report) {
  const auto taught = readServer(server, here.workstation());
  if (!taught) return tl::unexpected(taught.error());
  return inTransaction(here, Way::Write, [&](Transaction& transaction) -> Result<void> {
    report.people = takePeople(transaction, taught->people);
    report.cohorts = takeCohorts(transaction, *taught);
    report.curricula = takeCurricula(transaction, taught->curricula, report.troubles);
    takeOpenings(transaction, taught->openings, here.now_us());
    takeVoided(transaction, taught->voided);
    takeAccepted(transaction, taught->accepted, here.now_us());
    for (const Row& comment : taught->comments)
      if (transaction.row("SELECT id FROM attempts WHERE id = ?", comment.text(1))) mergeComment(transaction, comment);
    return {};
  });
}

}  // namespace insonate::store
