#include "store/AttemptRows.h"
#include "store/AuditChain.h"
#include "store/CurriculumRows.h"
#include "store/Paging.h"
#include "store/Session.h"
#include "store/StandingRows.h"
#include "store/StoredRecordings.h"

#include <insonate/curriculum/StoreCheck.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Row;
using store::Transaction;
using Differences = std::vector<StoreDifference>;

/// Entries of the audit log about an attempt; AttemptStore.cpp and site/SendFacts.cpp write them.
struct Logged {
  std::string person{};
  std::optional<std::string> level{};      ///< as the log shortens it; none for an attempt from a workstation
  std::optional<std::string> recording{};  ///< its hash; none if no end was logged
  bool wasReceived = false;
};

constexpr std::size_t kUuid = 36;
constexpr std::string_view kAtLevel = " at level ", kRecording = ", recording ";

std::string after(const std::string& text, std::string_view begin) {
  return text.starts_with(begin) ? text.substr(begin.size()) : std::string();
}

std::map<std::string, Logged> loggedAttempts(Transaction& transaction) {
  std::map<std::string, Logged> logged;
  for (const Row& row : transaction.rows("SELECT act, person, detail FROM audit WHERE act IN ('begin attempt', 'end "
                                         "attempt', 'receive attempt') ORDER BY number")) {
    const std::string detail = row.text(2), rest = detail.substr(std::min(kUuid, detail.size()));
    Logged& one = logged[detail.substr(0, kUuid)];
    one.person = row.text(1);
    if (row.text(0) == "begin attempt") one.level = after(rest, kAtLevel);
    if (row.text(0) == "end attempt") one.recording = after(rest, kRecording);
    one.wasReceived |= row.text(0) == "receive attempt";
  }
  return logged;
}

/// Attempts to which instructors did this by the log. Such an entry ends with the attempt (Session.cpp).
std::set<std::string> attemptsOf(Transaction& transaction, const std::string& act) {
  std::set<std::string> attempts;
  for (const Row& row : transaction.rows("SELECT detail FROM audit WHERE act = ? AND allowed = 1", act)) {
    const std::string detail = row.text(0);
    if (detail.size() >= kUuid) attempts.insert(detail.substr(detail.size() - kUuid));
  }
  return attempts;
}

/// Compares what instructors decided on attempts with the log. Decisions made on a server arrive at a workstation, and
/// those made at a workstation before it joined arrive at the server, with the attempt and without entries of their
/// own.
void compareDecisions(Transaction& transaction, const std::map<std::string, Logged>& logged, Differences& differences) {
  const auto voided = attemptsOf(transaction, "void attempt"), accepted = attemptsOf(transaction, "accept attempt");
  const auto site = transaction.row("SELECT server FROM site");
  const bool isWorkstation = site && !site->text(0).empty();
  for (const Row& row : transaction.rows("SELECT id, person, CASE WHEN voided_us IS NULL THEN 0 ELSE 1 END, CASE WHEN "
                                         "proofs.state = 'accepted' THEN 1 ELSE 0 END FROM attempts LEFT JOIN proofs "
                                         "ON attempt = id ORDER BY arrival")) {
    const std::string id = row.text(0);
    const auto entry = logged.find(id);
    const bool isElsewhere = isWorkstation || (entry != logged.end() && entry->second.wasReceived);
    const auto expect = [&](const char* what, bool is, bool wasLogged) {
      if (is == wasLogged || (is && isElsewhere)) return;
      differences.push_back({id, row.text(1), what, is ? "yes" : "no",
                             wasLogged ? "yes, according to the audit log" : "no: no entry of the audit log says so"});
    };
    expect("voided", row.truth(2), voided.contains(id));
    expect("accepted by an instructor", row.truth(3), accepted.contains(id));
  }
}

/// Compares a row with its entries.
void compare(const Row& row, const Logged& logged, Differences& differences) {
  const std::string id = row.text(1), person = row.text(2);
  const bool hasEnded = row.text(5) != "open" && !row.truth(6);
  const auto expect = [&](const char* field, const std::string& stored, const std::string& expected) {
    if (stored != expected) differences.push_back({id, person, field, stored, expected});
  };
  expect("person", person, logged.person);
  if (logged.level) expect("level", store::forLog(row.text(3)), *logged.level);
  if (logged.recording) expect("recording hash", row.text(4), *logged.recording);
  if (logged.recording && !hasEnded) expect("state", row.text(5), "ended, according to the audit log");
  if (!logged.recording && !logged.wasReceived && hasEnded)
    expect("state", row.text(5), "open, according to the audit log");
}

Differences compareWithLog(Transaction& transaction) {
  Differences differences;
  std::map<std::string, Logged> logged = loggedAttempts(transaction);
  compareDecisions(transaction, logged, differences);
  // A store that was created by schema 3 or later has an entry for each attempt.
  bool hasBegun = transaction.number("SELECT COUNT(DISTINCT applied_us) FROM schema_migrations WHERE number <= 3") == 1;
  for (const Row& row :
       transaction.rows("SELECT arrival, id, person, level, recording_hash, state, crashed FROM attempts "
                        "ORDER BY arrival")) {
    const auto found = logged.find(row.text(1));
    if (found != logged.end()) {
      hasBegun = true;
      compare(row, found->second, differences);
      logged.erase(found);
    } else if (hasBegun) {
      differences.push_back(
          {row.text(1), row.text(2), "attempt", "a row", "none: no entry of the audit log mentions it"});
    }
  }
  for (const auto& [id, entry] : logged)
    differences.push_back({id, entry.person, "attempt", "missing", "a row: the audit log mentions it"});
  return differences;
}

/// Computes the standing as of the time of the stored one, from the attempts that had ended by then.
Standing workedOut(const Curriculum& curriculum, const std::vector<AttemptFacts>& history, const Standing& kept) {
  return computeStanding(curriculum, history, computeProgress(curriculum, history, kept.from_us), kept.from_us,
                         kept.changes);
}

std::string nameOf(Concern concern) {
  return concern == Concern::Slipped ? "slipped" : concern == Concern::Stuck ? "stuck" : "none";
}

void compare(const Standing& kept, const Standing& expected, const std::string& person, Differences& differences) {
  const std::string of = "standing in " + kept.curriculum + " " + std::to_string(kept.curriculumVersion) + ": ";
  const auto expect = [&](const char* field, const std::string& stored, const std::string& follows) {
    if (stored != follows) differences.push_back({"", person, of + field, stored, follows});
  };
  expect("level", kept.level, expected.level);
  expect("levels mastered", std::to_string(kept.mastered), std::to_string(expected.mastered));
  expect("concern", nameOf(kept.concern), nameOf(expected.concern));
  expect("sentence", kept.sentence, expected.sentence);
  expect("valid until", std::to_string(kept.until_us), std::to_string(expected.until_us));
}

/// A standing that is out of date is computed again before it is shown.
void checkStanding(Transaction& transaction, const Row& row, std::int64_t now_us, Differences& differences) {
  const std::string person = row.text(10);
  const std::int64_t changes = transaction.number("SELECT " INSONATE_CHANGES " FROM attempts WHERE person = ?", person);
  if (!store::isCurrent(row, 0, changes, now_us)) return;
  const Standing kept = store::standingFrom(row, 0);
  const auto curriculum = store::publishedCurriculum(transaction, kept.curriculum, kept.curriculumVersion);
  if (!curriculum) return;  // StoreUpkeep::verify() reports the reason; standings in it are not shown
  const std::vector<AttemptFacts> history = store::historyOf(transaction, person);
  Standing expected = workedOut(*curriculum, history, kept);
  // An attempt that began later is open; the clock may have been ahead when it began.
  if (expected.until_us != kept.until_us) {
    std::vector<AttemptFacts> ended = history;
    std::erase_if(ended, [](const AttemptFacts& facts) { return facts.state == AttemptState::Open; });
    expected = workedOut(*curriculum, ended, kept);
  }
  compare(kept, expected, person, differences);
}

}  // namespace

Result<std::vector<StoredAttempt>> StoreCheck::attempts(std::int64_t after, int count) const {
  if (auto ok = store::checkPage(count); !ok) return tl::unexpected(ok.error());
  const store::Core& core = by_.session()->core();
  return by_.session()->read(
      {.act = Act::LookAfterStore, .detail = "read attempts after " + std::to_string(after)},
      [&](Transaction& transaction, const Actor&) -> Result<std::vector<StoredAttempt>> {
        std::vector<StoredAttempt> page;
        for (const Row& row : transaction.rows("SELECT " INSONATE_ATTEMPT_COLUMNS
                                               " FROM attempts WHERE arrival > ? ORDER BY arrival LIMIT ?",
                                               after, count)) {
          page.push_back(store::storedAttemptOf(row));
          store::findRecording(page.back(), core.recordings());
        }
        return page;
      });
}

Result<Differences> StoreCheck::againstLog() const {
  return by_.session()->read(
      {.act = Act::LookAfterStore, .detail = "compare attempts with the log"},
      [](Transaction& transaction, const Actor&) -> Result<Differences> { return compareWithLog(transaction); });
}

Result<Differences> StoreCheck::standings() const {
  const std::int64_t now_us = by_.session()->core().now_us();
  return by_.session()->read(
      {.act = Act::LookAfterStore, .detail = "work out standings"},
      [&](Transaction& transaction, const Actor&) -> Result<Differences> {
        Differences differences;
        for (const Row& row :
             transaction.rows("SELECT " INSONATE_STANDING_COLUMNS ", standings.person FROM standings ORDER BY person"))
          checkStanding(transaction, row, now_us, differences);
        return differences;
      });
}

}  // namespace insonate
