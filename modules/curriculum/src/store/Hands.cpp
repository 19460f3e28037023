#include "store/Hands.h"

#include "store/Texts.h"

#include <string>

namespace insonate::store {

Result<void> refuseKnownHands(Transaction& transaction, const AttemptFacts& facts) {
  if (facts.handsHash.empty()) return {};
  if (const auto known = transaction.row("SELECT attempt, since_us FROM hands WHERE hash = ?", facts.handsHash)) {
    if (known->text(0) == facts.id) return {};
    return fail("This recording was added already, on " + dayOf(known->number(1)) +
                ", under this name or another. A recording counts once, for one person; record another attempt.");
  }
  if (const auto earlier = facts.recordingHash.empty()
                               ? std::nullopt
                               : transaction.row("SELECT begun_us FROM attempts WHERE recording_hash = ? AND id <> ?",
                                                 facts.recordingHash, facts.id))
    return fail("This recording was added already, as an attempt of " + dayOf(earlier->number(0)) +
                ". A recording counts once, for one person; record another attempt.");
  return {};
}

void storeHandsHash(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us) {
  if (facts.handsHash.empty()) return;
  if (transaction.number("SELECT COUNT(*) FROM hands WHERE hash = ?", facts.handsHash) == 0)
    transaction.run("INSERT INTO hands VALUES (?, ?, ?)", facts.handsHash, facts.id, now_us);
}

}  // namespace insonate::store
