#include "store/AttemptRows.h"
#include "store/AuditChain.h"
#include "store/CrashedAttempts.h"
#include "store/Hands.h"
#include "store/OpeningRows.h"
#include "store/Outbox.h"
#include "store/Paging.h"
#include "store/PeopleRows.h"
#include "store/Seals.h"
#include "store/Session.h"
#include "store/StandingRows.h"
#include "store/StoredRecordings.h"
#include "store/Texts.h"
#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptStore.h>

#include <cstdint>
#include <string>

namespace insonate::store {

Result<void> refuseImpossibleDates(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us) {
  const std::int64_t latest_us = now_us + kClocksDiffer_us;
  if (facts.begun_us > latest_us || facts.length_us > latest_us - facts.begun_us)
    return fail("The attempt is dated " + dayOf(facts.begun_us) + ", which is in the future: it is now " +
                dayOf(now_us) + " by the clock of this computer. Check the clock, and add the attempt after its end.");
  if (facts.curriculum.empty()) return {};
  const auto published = transaction.row("SELECT published_us FROM curricula WHERE name = ? AND version = ?",
                                         facts.curriculum, facts.curriculumVersion);
  if (!published || facts.begun_us >= published->number(0) - kClocksDiffer_us) return {};
  return fail("The attempt is dated " + dayOf(facts.begun_us) + ", and its level was published later, on " +
              dayOf(published->number(0)) + ". Keep it as free practice, or record an attempt at the level.");
}

}  // namespace insonate::store

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Row;
using store::Transaction;

tl::unexpected<Error> otherwiseBegun(const std::string& id) {
  return fail("The attempt " + id +
              " was already begun with another person, level, procedure, case or time, which cannot be changed. Begin "
              "another attempt.");
}

/// Replaces the sitting that the caller states.
AttemptFacts decided(AttemptFacts facts, TestConditions testConditions) {
  facts.testConditions = testConditions;
  return facts;
}

/// An attempt that is added after its end has begun at its time, like one whose beginning arrived late. Demonstrations
/// show a class whose tests were open.
TestConditions sittingOfAdded(Transaction& transaction, const AttemptFacts& facts) {
  const TestConditions sitting = store::sittingAt(transaction, facts, facts.begun_us);
  const bool isDemonstrated = facts.proof == AttemptProof::Demonstration && sitting != TestConditions::None;
  return isDemonstrated ? TestConditions::Opened : sitting;
}

/// The first decision is final, but for a beginning that arrived late.
void settleSitting(Transaction& transaction, const AttemptFacts& kept) {
  if (kept.testConditions == TestConditions::Undecided)
    transaction.run("UPDATE attempts SET sitting = ? WHERE id = ?",
                    store::nameOf(store::sittingAt(transaction, kept, kept.begun_us)), kept.id);
}

Result<std::string> beginAttempt(Transaction& transaction, const Core& core, const AttemptFacts& facts) {
  if (const auto kept = store::findAttempt(transaction, facts.id)) {
    if (!store::sameBeginning(kept->facts, facts)) return otherwiseBegun(facts.id);
    return facts.id;
  }
  if (auto ok = store::refuseImpossibleDates(transaction, facts, core.now_us()); !ok) return tl::unexpected(ok.error());
  store::storeRun(transaction, core);
  store::insertAttempt(transaction, facts, core.run());
  store::putIntoOutbox(transaction, core, "attempt", facts.id);
  core.audit(transaction, facts.person, "begin attempt", facts.person,
             facts.id + (facts.level.empty() ? ", free practice" : " at level " + store::forLog(facts.level)));
  return facts.id;
}

/// A voided attempt has ended, too: its end is the state before it was voided.
Result<void> endKept(Transaction& transaction, const Core& core, const AttemptFacts& facts) {
  auto kept = store::findAttempt(transaction, facts.id);
  if (!kept) return fail("There is no attempt " + facts.id + "; begin it first.");
  if (!store::sameBeginning(kept->facts, facts)) return otherwiseBegun(facts.id);
  const bool isVoided = kept->facts.state == AttemptState::Voided;
  if (isVoided) kept->facts.state = facts.state;
  if (kept->facts.state != AttemptState::Open && !kept->crashed) {
    if (store::sameEnd(kept->facts, facts)) return {};
    return fail("The attempt " + facts.id + " has already ended with another result, which cannot be changed.");
  }
  if (auto ok = store::refuseImpossibleDates(transaction, facts, core.now_us()); !ok) return ok;
  if (auto ok = store::refuseKnownHands(transaction, facts); !ok) return ok;
  settleSitting(transaction, kept->facts);
  store::endAttempt(transaction, facts, false);
  store::storeHandsHash(transaction, facts, core.now_us());
  store::storeProof(transaction, facts);
  store::renewStandings(transaction, facts.person, core.now_us());
  store::putIntoOutbox(transaction, core, "attempt", facts.id);
  core.audit(transaction, facts.person, "end attempt", facts.person,
             facts.id + (facts.recordingHash.empty() ? ", without a recording" : ", recording " + facts.recordingHash));
  return {};
}

Result<void> voidKept(Transaction& transaction, const Core& core, const std::string& id, const std::string& by,
                      const std::string& reason) {
  const auto kept = store::findAttempt(transaction, id);
  if (kept->facts.state == AttemptState::Open)
    return fail("The attempt is still open; it can be voided once it has ended.");
  if (kept->facts.state == AttemptState::Voided) {
    if (kept->voidReason == reason) return {};
    return fail("The attempt was voided already: " + kept->voidReason);
  }
  if (auto ok = store::checkTakesTexts(transaction, kept->facts.person); !ok) return ok;
  transaction.run("UPDATE attempts SET voided_us = ?, voided_by = ?, void_reason = ? WHERE id = ?", core.now_us(), by,
                  reason, id);
  store::renewStandings(transaction, kept->facts.person, core.now_us());
  store::putIntoOutbox(transaction, core, "attempt", id);
  return {};
}

/// Ends the verification of an attempt whose recording has not arrived, perhaps since its workstation is lost.
Result<void> waitNoMore(Transaction& transaction, const Core& core, const std::string& id) {
  const auto waiting = transaction.row("SELECT received_us FROM verifications WHERE attempt = ?", id);
  if (!waiting || !waiting->isNull(0))
    return fail("The server is verifying the attempt. Wait until it has finished, then look at the attempt again.");
  transaction.run("UPDATE verifications SET ended_us = ?, why = ? WHERE attempt = ?", core.now_us(),
                  "It was accepted before its recording arrived.", id);
  store::concludeProof(transaction, id, AttemptProof::Unproven);
  return {};
}

Result<void> acceptKept(Transaction& transaction, const Core& core, const std::string& id, const std::string& by) {
  const auto kept = store::findAttempt(transaction, id);
  const AttemptFacts& facts = kept->facts;
  if (facts.proof == AttemptProof::Accepted) return {};
  if (auto ok = store::checkTakesTexts(transaction, facts.person); !ok) return ok;
  if (facts.state == AttemptState::Open || facts.state == AttemptState::Voided || kept->crashed)
    return fail(
        "Only an attempt that has ended can be accepted, but this attempt is still open, was voided, or has a "
        "recording that stopped early.");
  if (facts.testConditions == TestConditions::Practice)
    return fail("The test was not open when the attempt began, so the attempt is practice and stays practice.");
  if (facts.proof == AttemptProof::Verifying) {
    if (auto ended = waitNoMore(transaction, core, id); !ended) return ended;
  } else if (facts.proof != AttemptProof::Unproven) {
    return fail("The attempt counts already. It does not need to be accepted.");
  }
  store::acceptAttempt(transaction, id, by);
  // The standings were computed without this attempt.
  transaction.run("DELETE FROM standings WHERE person = ?", facts.person);
  store::renewStandings(transaction, facts.person, core.now_us());
  store::putIntoOutbox(transaction, core, "attempt", id);
  return {};
}

Result<void> checkReason(const std::string& reason, const char* what) {
  if (auto ok = store::checkText("The reason", reason); !ok) return ok;
  if (reason.find_first_not_of(" \t\r\n") != std::string::npos) return {};
  return fail(std::string("An attempt is ") + what + " for a reason; type it.");
}

/// Attempts from the arrival of the first of each person's last attempts on.
constexpr std::string_view kLastOfCohort =
    "WITH since AS (SELECT m.person, COALESCE((SELECT arrival FROM attempts AS a WHERE a.person = m.person "
    "AND " INSONATE_AT_LEVELS " AND " INSONATE_COUNTS
    " ORDER BY arrival DESC LIMIT 1 OFFSET ?), 0) AS first "
    "FROM memberships AS m WHERE m.cohort = ? AND m.teaches = 0) "
    "SELECT arrival, id, attempts.person, curriculum, curriculum_version, level, procedure, procedure_version, "
    "case_name, "
    "begun_us, state, crashed, length_us, succeeded, critical_errors, points, metrics, "
    "voided_us, " INSONATE_PROOF_COLUMN
    ", sitting "
    "FROM since JOIN attempts ON attempts.person = since.person AND arrival >= since.first "
    "WHERE " INSONATE_AT_LEVELS " AND " INSONATE_COUNTS " ORDER BY attempts.person, arrival";

/// Completes facts as the store keeps them: the signed-in user, this workstation, an id.
AttemptFacts ownFacts(const SignedIn& by, AttemptFacts facts) {
  facts.person = by.person().id;
  facts.workstation = by.session()->core().workstation();
  if (facts.id.empty()) facts.id = store::freshUuid();
  return facts;
}

}  // namespace

Result<std::string> AttemptStore::begin(const AttemptFacts& facts) const {
  Core& core = by_.session()->core();
  const AttemptFacts begun = ownFacts(by_, facts);
  if (auto ok = store::checkBegun(begun); !ok) return tl::unexpected(ok.error());
  return by_.session()->write({.act = Act::MakeAttempt, .person = begun.person}, [&](Transaction& transaction,
                                                                                     const Actor&) {
    return beginAttempt(transaction, core, decided(begun, store::sittingOnArrival(transaction, begun, core.now_us())));
  });
}

Result<void> AttemptStore::end(const AttemptFacts& facts) const {
  if (auto ok = store::checkEnded(facts); !ok) return ok;
  AttemptFacts ended = facts;
  ended.person = by_.person().id;
  return by_.session()->write(
      {.act = Act::MakeAttempt, .attempt = facts.id},
      [&](Transaction& transaction, const Actor&) { return endKept(transaction, by_.session()->core(), ended); });
}

Result<std::string> AttemptStore::add(const AttemptFacts& facts, const std::filesystem::path& recording) const {
  Core& core = by_.session()->core();
  const AttemptFacts own = ownFacts(by_, facts);
  if (auto ok = store::checkBegun(own); !ok) return tl::unexpected(ok.error());
  if (auto ok = store::checkEnded(own); !ok) return tl::unexpected(ok.error());
  bool isNewFile = false;
  auto added = by_.session()->write(
      {.act = Act::MakeAttempt, .person = own.person},
      [&](Transaction& transaction, const Actor&) -> Result<std::string> {
        auto begun = beginAttempt(transaction, core, decided(own, sittingOfAdded(transaction, own)));
        if (!begun) return begun;
        if (auto ended = endKept(transaction, core, own); !ended) return tl::unexpected(ended.error());
        if (recording.empty() || core.recordings().empty()) return begun;
        // Copies the recording before the row is committed: a row whose recording was
        // lost would count without proof.
        const auto kept = store::storeRecording(core.recordings(), own.id, recording, own.recordingHash);
        if (!kept) return tl::unexpected(kept.error());
        isNewFile = *kept;
        return begun;
      });
  std::error_code ignored;
  if (!added && isNewFile) std::filesystem::remove(store::storedRecording(core.recordings(), own.id), ignored);
  return added;
}

Result<void> AttemptStore::storeRecording(const std::string& attempt, const std::filesystem::path& recording) const {
  const std::filesystem::path& folder = by_.session()->core().recordings();
  const auto kept = by_.session()->read({.act = Act::MakeAttempt, .attempt = attempt},
                                        [&](Transaction& transaction, const Actor&) -> Result<std::string> {
                                          const auto found = store::findAttempt(transaction, attempt);
                                          return found ? found->facts.recordingHash : std::string();
                                        });
  if (!kept) return tl::unexpected(kept.error());
  if (kept->empty())
    return fail("The attempt " + attempt + " has no recording; end the attempt with a recording first.");
  if (folder.empty()) return {};
  const auto copied = store::storeRecording(folder, attempt, recording, *kept);
  return copied ? Result<void>() : tl::unexpected(copied.error());
}

Result<AttemptSeal> AttemptStore::issueSeal(const AttemptFacts& facts) const {
  const AttemptFacts own = ownFacts(by_, facts);
  if (auto ok = store::checkBegun(own); !ok) return tl::unexpected(ok.error());
  return by_.session()->read(
      {.act = Act::MakeAttempt, .person = own.person},
      [&](Transaction& transaction, const Actor&) { return store::freshSeal(transaction, own); });
}

Result<NonceOrigin> AttemptStore::originOf(const AttemptFacts& facts, const std::string& nonce) const {
  return by_.session()->read(
      {.act = Act::SeeAttempts, .person = facts.person},
      [&](Transaction& transaction, const Actor&) { return store::originOfNonce(transaction, facts, nonce); });
}

Result<void> AttemptStore::accept(const std::string& attempt, const std::string& reason) const {
  if (auto ok = checkReason(reason, "accepted"); !ok) return ok;
  return by_.session()->write({.act = Act::AcceptAttempt, .attempt = attempt, .detail = reason},
                              [&](Transaction& transaction, const Actor& actor) {
                                return acceptKept(transaction, by_.session()->core(), attempt, actor.id);
                              });
}

Result<void> AttemptStore::voidAttempt(const std::string& attempt, const std::string& reason) const {
  if (auto ok = checkReason(reason, "voided"); !ok) return ok;
  return by_.session()->write({.act = Act::VoidAttempt, .attempt = attempt, .detail = reason},
                              [&](Transaction& transaction, const Actor& actor) {
                                return voidKept(transaction, by_.session()->core(), attempt, actor.id, reason);
                              });
}

Result<StoredAttempt> AttemptStore::attempt(const std::string& id) const {
  return by_.session()->read({.act = Act::SeeAttempts, .attempt = id},
                             [&](Transaction& transaction, const Actor&) -> Result<StoredAttempt> {
                               auto kept = store::findAttempt(transaction, id);
                               if (!kept) return fail("There is no attempt " + id + "; reload the list.");
                               store::findRecording(*kept, by_.session()->core().recordings());
                               return *kept;
                             });
}

Result<std::vector<StoredAttempt>> AttemptStore::page(const std::string& person, int count, std::int64_t before) const {
  if (auto ok = store::checkPage(count); !ok) return tl::unexpected(ok.error());
  return by_.session()->read({.act = Act::SeeAttempts, .person = person},
                             [&](Transaction& transaction, const Actor&) -> Result<std::vector<StoredAttempt>> {
                               std::vector<StoredAttempt> page;
                               for (const Row& row : transaction.rows(
                                        "SELECT " INSONATE_ATTEMPT_COLUMNS
                                        " FROM attempts WHERE person = ? AND arrival < ? ORDER BY arrival DESC LIMIT ?",
                                        person, store::endOfPage(before), count)) {
                                 page.push_back(store::storedAttemptOf(row));
                                 store::findRecording(page.back(), by_.session()->core().recordings());
                               }
                               return page;
                             });
}

Result<std::vector<AttemptFacts>> AttemptStore::history(const std::string& person) const {
  return by_.session()->read({.act = Act::SeeAttempts, .person = person},
                             [&](Transaction& transaction, const Actor&) -> Result<std::vector<AttemptFacts>> {
                               return store::historyOf(transaction, person);
                             });
}

Result<std::vector<AttemptFacts>> AttemptStore::recentOfCohort(const std::string& cohort, int count) const {
  if (auto ok = store::checkPage(count); !ok) return tl::unexpected(ok.error());
  return by_.session()->read({.act = Act::SeeCohortAttempts, .cohort = cohort},
                             [&](Transaction& transaction, const Actor&) -> Result<std::vector<AttemptFacts>> {
                               return store::allFacts(transaction.rows(kLastOfCohort, count - 1, cohort));
                             });
}

Result<std::string> AttemptStore::findByRecording(const std::string& name, const std::string& hash) const {
  return by_.session()->read(
      {.act = Act::FindRecording}, [&](Transaction& transaction, const Actor&) -> Result<std::string> {
        if (const auto same =
                hash.empty() ? std::nullopt : transaction.row("SELECT id FROM attempts WHERE recording_hash = ?", hash))
          return same->text(0);
        const auto named =
            name.empty()
                ? std::nullopt
                : transaction.row(
                      "SELECT id FROM attempts WHERE recording = ? AND workstation = ? ORDER BY arrival DESC LIMIT 1",
                      name, by_.session()->core().workstation());
        return named ? named->text(0) : std::string();
      });
}

Result<std::int64_t> AttemptStore::changes(const std::string& person) const {
  return by_.session()->read(
      {.act = Act::SeeAttempts, .person = person}, [&](Transaction& transaction, const Actor&) -> Result<std::int64_t> {
        return transaction.number("SELECT " INSONATE_CHANGES " FROM attempts WHERE person = ?", person);
      });
}

}  // namespace insonate
