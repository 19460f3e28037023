#include "store/AuditChain.h"
#include "store/CommentRows.h"
#include "store/CurriculumRows.h"
#include "store/OpeningRows.h"
#include "store/PersonErasure.h"
#include "store/Proofs.h"
#include "store/RetentionRows.h"
#include "store/StandingRows.h"
#include "store/StoredRecordings.h"
#include "store/Texts.h"
#include "store/site/Site.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace insonate::store {
namespace {

/// Not a hash, so that no password fits.
const std::string kNoPassword = "*";
constexpr std::string_view kCohorts =
    "SELECT id, name, name_key, curriculum, curriculum_version, archived FROM cohorts";
constexpr std::string_view kMemberships = "SELECT cohort || ' ' || person, cohort, person, teaches FROM memberships";

std::string peopleQuery() {
  return "SELECT " + std::string(kPeopleColumns) + " FROM people JOIN credentials ON person = id";
}

Rows rowsByKey(Transaction& transaction, std::string_view sql) {
  Rows rows;
  for (const Row& row : transaction.rows(sql)) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < row.size(); ++i) texts.push_back(row.text(i));
    rows[row.text(0)] = std::move(texts);
  }
  return rows;
}

/// People of whom an untrusted workstation may have data.
struct PeopleFor {
  std::set<std::string> known{};     ///< those who have signed in at it, and the learners of the instructors among them
  std::set<std::string> teachers{};  ///< instructors of these people: a person without one takes tests alone
};

PeopleFor peopleFor(Transaction& transaction, const std::string& workstation) {
  PeopleFor people;
  for (const Row& row : transaction.rows(
           "SELECT person FROM workstation_people WHERE workstation = ? UNION "
           "SELECT theirs.person FROM workstation_people AS here JOIN people ON people.id = here.person AND disabled = "
           "0 JOIN memberships AS own ON own.person = here.person AND own.teaches = 1 JOIN memberships AS theirs ON "
           "theirs.cohort = own.cohort AND theirs.teaches = 0 WHERE workstation = ?",
           workstation, workstation))
    people.known.insert(row.text(0));
  for (const Row& row : transaction.rows(
           "SELECT DISTINCT theirs.person FROM workstation_people AS here JOIN memberships AS own ON own.person = "
           "here.person JOIN memberships AS theirs ON theirs.cohort = own.cohort AND theirs.teaches = 1 WHERE "
           "workstation = ?",
           workstation))
    people.teachers.insert(row.text(0));
  return people;
}

/// State of the attempts that a person made at other workstations than this. Both kinds of database must give the same
/// texts: a condition such as "voided_us IS NOT NULL" is 1 in one and t in the other.
std::string digestOf(Transaction& transaction, const std::string& person, const std::string& workstation) {
  std::string state;
  for (const Row& row :
       transaction.rows("SELECT id, state, crashed, sitting, CASE WHEN voided_us IS NULL THEN 0 ELSE 1 END, "
                        "COALESCE((SELECT proofs.state FROM "
                        "proofs WHERE attempt = attempts.id), 'unproven') FROM attempts WHERE person = ? AND "
                        "workstation <> ? AND state <> 'open' "
                        "ORDER BY id",
                        person, workstation))
    for (std::size_t i = 0; i < row.size(); ++i) state += row.text(i) + ' ';
  return state.empty() ? "" : sha256(state);
}

/// The attempts of people whose attempts elsewhere are not known to the workstation as they are now.
AttemptsElsewhere elsewhereAfter(Transaction& transaction, const std::set<std::string>& people,
                                 const std::string& workstation, const Digests& known, const std::string& after) {
  constexpr std::size_t kEnough = 200;
  AttemptsElsewhere part;
  for (auto person = people.upper_bound(after); person != people.end(); ++person) {
    const auto digest = known.find(*person);
    if (digestOf(transaction, *person, workstation) == (digest == known.end() ? "" : digest->second)) continue;
    for (const Row& attempt :
         transaction.rows("SELECT id FROM attempts WHERE person = ? AND workstation <> ? AND state <> 'open' "
                          "ORDER BY arrival",
                          *person, workstation))
      if (auto sent = readAttempt(transaction, attempt.text(0))) part.attempts.push_back(std::move(*sent));
    if (part.attempts.size() < kEnough || std::next(person) == people.end()) continue;
    part.last = *person;
    break;
  }
  return part;
}

/// Leaves out what an untrusted workstation does not need: other people, their classes, and all passwords. The ids of
/// erased people stay: the workstation may still have an instructor who no longer teaches.
void restrict(Taught& taught, const PeopleFor& people) {
  const auto isFor = [&](const std::string& id) { return people.known.contains(id) || people.teachers.contains(id); };
  std::erase_if(taught.people, [&](const auto& row) { return !isFor(row.first); });
  for (auto& [id, row] : taught.people) {
    row[kPasswordColumn].clear();
    if (!people.known.contains(id)) row[kEmailColumn].clear();
  }
  std::erase_if(taught.memberships, [&](const auto& row) { return !isFor(row.second[2]); });
  std::set<std::string> cohorts;
  for (const auto& [key, row] : taught.memberships) cohorts.insert(row[1]);
  std::erase_if(taught.cohorts, [&](const auto& row) { return !cohorts.contains(row.first); });
  std::erase_if(taught.openings,
                [&](const Row& row) { return !row.text(1).empty() && !cohorts.contains(row.text(1)); });
}

/// A password that the server does not send stays as it is here; if the server has another one, the person must sign in
/// to the server first.
void keepPasswords(Taught& taught, const Rows& own) {
  for (auto& [id, row] : taught.people) {
    if (!row[kPasswordColumn].empty()) continue;
    const auto here = own.find(id);
    const bool isSame = here != own.end() && here->second[kVersionColumn] == row[kVersionColumn];
    row[kPasswordColumn] = isSame ? here->second[kPasswordColumn] : kNoPassword;
  }
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

int takePeople(Transaction& here, Taught& taught) {
  const Rows own = rowsByKey(here, peopleQuery());
  keepPasswords(taught, own);
  // A password that was changed here and has not been sent is newer than the server's.
  std::set<std::string> unsent;
  for (const Row& row : here.rows("SELECT id FROM outbox WHERE kind = 'password'")) unsent.insert(row.text(0));
  const auto rows = changed(taught.people, own);
  // Two people may have exchanged names: existing names are cleared before new ones are assigned.
  // A name may also have belonged to a person of whom the server tells nothing anymore.
  for (const auto& row : rows) here.run("UPDATE people SET name_key = id WHERE id = ? OR name_key = ?", row[0], row[2]);
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

/// Erases people before their rows get the names of the server, by which their names in the log are found.
Result<void> takeErased(Transaction& here, const Core& core, const std::vector<std::string>& erased) {
  for (const std::string& person : erased)
    if (here.row("SELECT id FROM people WHERE id = ?", person))
      if (auto done = erasePerson(here, core, person, ""); !done) return done;
  return {};
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
        "INSERT INTO cohorts VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (id) DO UPDATE SET name = excluded.name, "
        "name_key = excluded.name_key, curriculum = excluded.curriculum, curriculum_version = "
        "excluded.curriculum_version, archived = excluded.archived",
        row[0], row[1], row[2], row[3], numberIn(row[4]), numberIn(row[5]));
  for (const auto& row : changed(server.memberships, ownMembers))
    here.run(
        "INSERT INTO memberships VALUES (?, ?, ?) ON CONFLICT (cohort, person) DO UPDATE SET teaches = "
        "excluded.teaches",
        row[1], row[2], numberIn(row[3]));
  return static_cast<int>(rows.size());
}

int takeCurricula(Transaction& here, const std::vector<StoredCurriculum>& server, std::vector<std::string>& troubles) {
  int taken = 0;
  for (const StoredCurriculum& theirs : server) {
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
          " differs between the server and this computer. Publish the right text on the server as a later version.");
    }
  }
  return taken;
}

/// Voids here what instructors voided on the server, for attempts made here.
void takeVoided(Transaction& here, const std::vector<Row>& voided, std::set<std::string>& changed) {
  for (const Row& row : voided)
    if (here.run("UPDATE attempts SET voided_us = ?, voided_by = ?, void_reason = ? WHERE id = ? AND voided_us IS NULL "
                 "AND state <> 'open'",
                 row.number(1), row.text(2), row.text(3), row.text(0)) > 0)
      changed.insert(here.row("SELECT person FROM attempts WHERE id = ?", row.text(0))->text(0));
}

/// Withdraws the proofs of attempts that the server could not verify.
void takeRefused(Transaction& here, const Core& core, const std::vector<Row>& refused,
                 std::vector<std::string>& troubles) {
  for (const Row& row : refused) {
    const auto attempt = here.row(
        "SELECT person, begun_us FROM attempts JOIN proofs ON attempt = id WHERE id = ? AND proofs.state = 'proven'",
        row.text(0));
    if (!attempt) continue;
    here.run("UPDATE proofs SET state = 'unproven' WHERE attempt = ?", row.text(0));
    here.run("DELETE FROM standings WHERE person = ?", attempt->text(0));
    renewStandings(here, attempt->text(0), core.now_us());
    core.audit(here, "", "refuse attempt", attempt->text(0), row.text(0) + ": " + forLog(row.text(1)), false);
    troubles.push_back("The server could not verify the attempt of " + dayOf(attempt->number(1)) + ": " + row.text(1) +
                       " It does not count as a pass until an instructor accepts it.");
  }
}

/// Applies the server's acceptances of attempts of this workstation.
void takeAccepted(Transaction& here, const std::vector<Row>& accepted, std::int64_t now_us,
                  std::set<std::string>& changed) {
  for (const Row& row : accepted) {
    const auto person = here.row(
        "SELECT person FROM attempts JOIN proofs ON attempt = attempts.id WHERE attempts.id = ? AND proofs.state = "
        "'unproven'",
        row.text(0));
    if (!person) continue;
    acceptAttempt(here, row.text(0), row.text(1));
    here.run("DELETE FROM standings WHERE person = ?", person->text(0));
    renewStandings(here, person->text(0), now_us);
    changed.insert(person->text(0));
  }
}

void takeComments(Transaction& here, const std::vector<Row>& comments, std::set<std::string>& changed) {
  for (const Row& comment : comments) {
    const auto attempt = here.row("SELECT person FROM attempts WHERE id = ?", comment.text(1));
    if (attempt && mergeComment(here, comment)) changed.insert(attempt->text(0));
  }
}

}  // namespace

Result<Taught> readTaught(Core& server, const Sender& sender) {
  return inTransaction(server, Way::Read, [&](Transaction& transaction) -> Result<Taught> {
    Taught taught{rowsByKey(transaction, peopleQuery()), rowsByKey(transaction, kCohorts),
                  rowsByKey(transaction, kMemberships)};
    for (const CurriculumEntry& entry : listCurricula(transaction))
      if (auto kept = findCurriculum(transaction, entry.name, entry.version))
        taught.curricula.push_back(std::move(*kept));
    taught.voided = transaction.rows(
        "SELECT id, voided_us, voided_by, void_reason FROM attempts WHERE workstation = ? AND voided_us IS NOT NULL",
        sender.workstation);
    taught.accepted = transaction.rows(
        "SELECT attempt, accepted_by FROM proofs JOIN attempts ON attempts.id = attempt WHERE workstation = ? AND "
        "proofs.state = 'accepted'",
        sender.workstation);
    taught.refused = transaction.rows(
        "SELECT verifications.attempt, why FROM verifications JOIN attempts ON attempts.id = verifications.attempt "
        "WHERE workstation = ? AND ended_us IS NOT NULL AND why <> '' ORDER BY verifications.attempt",
        sender.workstation);
    taught.comments = transaction.rows(
        "SELECT " INSONATE_COMMENT_COLUMNS
        " FROM comments JOIN attempts ON attempts.id = attempt WHERE workstation = ? ORDER BY comments.id",
        sender.workstation);
    taught.openings = transaction.rows("SELECT " INSONATE_OPENING_COLUMNS " FROM openings ORDER BY id");
    taught.deleted_us = recordingsDeletedBefore_us(transaction);
    for (const Row& row : transaction.rows("SELECT person FROM erasures ORDER BY person"))
      taught.erased.push_back(row.text(0));
    if (!sender.isTrusted) restrict(taught, peopleFor(transaction, sender.workstation));
    return taught;
  });
}

Result<AttemptsElsewhere> readElsewhere(Core& server, const Sender& sender, const Digests& known,
                                        const std::string& after) {
  if (sender.isTrusted) return AttemptsElsewhere{};
  return inTransaction(server, Way::Read, [&](Transaction& transaction) -> Result<AttemptsElsewhere> {
    return elsewhereAfter(transaction, peopleFor(transaction, sender.workstation).known, sender.workstation, known,
                          after);
  });
}

Result<Digests> digestsHere(Core& here) {
  return inTransaction(here, Way::Read, [&](Transaction& transaction) -> Result<Digests> {
    Digests digests;
    for (const Row& row : transaction.rows("SELECT id FROM people"))
      if (std::string digest = digestOf(transaction, row.text(0), here.workstation()); !digest.empty())
        digests[row.text(0)] = std::move(digest);
    return digests;
  });
}

Result<void> takeTaught(Core& here, Taught taught, UploadReport& report) {
  std::vector<std::string> deleted;
  auto taken = inTransaction(here, Way::Write, [&](Transaction& transaction) -> Result<void> {
    if (auto done = takeErased(transaction, here, taught.erased); !done) return done;
    deleted = erasedAttempts(transaction);
    if (taught.deleted_us)
      for (std::string& attempt : attemptsBefore(transaction, *taught.deleted_us))
        deleted.push_back(std::move(attempt));
    report.people = takePeople(transaction, taught);
    report.cohorts = takeCohorts(transaction, taught);
    report.curricula = takeCurricula(transaction, taught.curricula, report.errors);
    for (const Row& opening : taught.openings) mergeOpening(transaction, opening);
    std::set<std::string> changed;
    takeVoided(transaction, taught.voided, changed);
    takeRefused(transaction, here, taught.refused, report.errors);
    takeAccepted(transaction, taught.accepted, here.now_us(), changed);
    takeComments(transaction, taught.comments, changed);
    for (const std::string& person : changed) here.audit(transaction, "", "receive from server", person, "");
    return {};
  });
  if (!taken) return taken;
  if (auto removed = removeRecordings(here.recordings(), deleted); !removed)
    report.errors.push_back(removed.error().message);
  return {};
}

Result<void> takeElsewhere(Core& here, const std::vector<SentAttempt>& attempts, UploadReport& report) {
  if (attempts.empty()) return {};
  return inTransaction(here, Way::Write, [&](Transaction& transaction) -> Result<void> {
    std::set<std::string> people;
    for (const SentAttempt& sent : attempts) {
      // A person who has come to this workstation since the directory was read arrives with the next exchange.
      if (!transaction.row("SELECT id FROM people WHERE id = ?", sent.ended.person)) continue;
      if (auto merged = mergeAttempt(transaction, Sender{}, sent, here.now_us()); !merged)
        report.errors.push_back(merged.error().message);
      people.insert(sent.ended.person);
    }
    for (const std::string& person : people) {
      transaction.run("DELETE FROM standings WHERE person = ?", person);
      renewStandings(transaction, person, here.now_us());
      here.audit(transaction, "", "receive from server", person, "");
    }
    return {};
  });
}

}  // namespace insonate::store
