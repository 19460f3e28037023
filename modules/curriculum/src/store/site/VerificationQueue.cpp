#include "store/AttemptRows.h"
#include "store/AuditChain.h"
#include "store/CurriculumRows.h"
#include "store/Seals.h"
#include "store/StandingRows.h"
#include "store/StoredRecordings.h"
#include "store/Texts.h"

#include <insonate/curriculum/VerificationQueue.h>

namespace insonate {
namespace {

using store::Core;
using store::Transaction;
using store::Way;

/// Long recordings are verified in seconds. If a server is only slow, two servers verify the attempt, and the first
/// result counts.
constexpr std::int64_t kLongestTaken_us = std::int64_t{2} * 60 * 1'000'000;

}  // namespace

Result<std::optional<WaitingAttempt>> VerificationQueue::takeNext() const {
  using Outcome = Result<std::optional<WaitingAttempt>>;
  Core& core = *server_.core_;
  const std::int64_t now_us = core.now_us();
  const auto next = [&](Transaction& transaction) {
    return transaction.row(
        "SELECT attempt FROM verifications JOIN attempts ON attempts.id = attempt "
        "JOIN workstations ON workstations.name = attempts.workstation "
        "WHERE ended_us IS NULL AND received_us IS NOT NULL AND store_secret <> '' AND "
        "(taken_us IS NULL OR taken_us < ? OR taken_us > ?) ORDER BY COALESCE(taken_us, 0), received_us LIMIT 1",
        now_us - kLongestTaken_us, now_us + kLongestTaken_us);
  };
  // Most of the time nothing waits, and a transaction for writing would hold up others.
  const auto waits = inTransaction(
      core, Way::Read, [&](Transaction& transaction) -> Result<bool> { return next(transaction).has_value(); });
  if (!waits) return tl::unexpected(waits.error());
  if (!*waits) return std::nullopt;
  return inTransaction(core, Way::Write, [&](Transaction& transaction) -> Outcome {
    const auto row = next(transaction);
    if (!row) return std::nullopt;
    transaction.run("UPDATE verifications SET taken_us = ? WHERE attempt = ?", now_us, row->text(0));
    auto kept = store::findAttempt(transaction, row->text(0));
    if (!kept) return std::nullopt;
    return WaitingAttempt{std::move(kept->facts), store::storedRecording(core.recordings(), row->text(0))};
  });
}

Result<NonceOrigin> VerificationQueue::originOf(const std::string& workstation, const AttemptFacts& facts,
                                                const std::string& nonce) const {
  return inTransaction(*server_.core_, Way::Read, [&](Transaction& transaction) -> Result<NonceOrigin> {
    const auto row = transaction.row("SELECT store_secret FROM workstations WHERE name = ?", workstation);
    return store::originBySecret(row ? row->text(0) : "", facts, nonce);
  });
}

Result<std::optional<Level>> VerificationQueue::levelOf(const AttemptFacts& facts) const {
  return inTransaction(*server_.core_, Way::Read, [&](Transaction& transaction) -> Result<std::optional<Level>> {
    if (!store::findCurriculum(transaction, facts.curriculum, facts.curriculumVersion)) return std::nullopt;
    const auto curriculum = store::publishedCurriculum(transaction, facts.curriculum, facts.curriculumVersion);
    if (!curriculum) return tl::unexpected(curriculum.error());
    const Level* level = curriculum->level(facts.level);
    return level ? std::optional(*level) : std::nullopt;
  });
}

Result<void> VerificationQueue::storeResult(const std::string& attempt, bool isVerified, const std::string& why) const {
  Core& core = *server_.core_;
  return inTransaction(core, Way::Write, [&](Transaction& transaction) -> Result<void> {
    const auto person = transaction.row(
        "SELECT person FROM attempts JOIN verifications ON attempt = id WHERE id = ? AND ended_us IS NULL", attempt);
    if (!person) return {};  // another server was faster
    transaction.run("UPDATE verifications SET ended_us = ?, why = ? WHERE attempt = ?", core.now_us(), why, attempt);
    store::concludeProof(transaction, attempt, isVerified ? AttemptProof::Proven : AttemptProof::Unproven);
    // The standings were computed without this attempt.
    transaction.run("DELETE FROM standings WHERE person = ?", person->text(0));
    store::renewStandings(transaction, person->text(0), core.now_us());
    core.audit(transaction, "", isVerified ? "verify attempt" : "refuse attempt", person->text(0),
               attempt + (why.empty() ? "" : ": " + store::forLog(why)), isVerified);
    return {};
  });
}

Result<std::int64_t> VerificationQueue::waiting() const {
  return inTransaction(*server_.core_, Way::Read, [](Transaction& transaction) -> Result<std::int64_t> {
    return transaction.number("SELECT COUNT(*) FROM verifications WHERE ended_us IS NULL");
  });
}

}  // namespace insonate
