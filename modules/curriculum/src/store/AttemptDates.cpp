#include "store/AttemptDates.h"

#include "store/Texts.h"

#include <string>

namespace insonate::store {

Result<void> refuseImpossibleDates(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us) {
  const std::int64_t latest_us = now_us + kClocksDiffer_us;
  if (facts.begun_us > latest_us || facts.length_us > latest_us - facts.begun_us)
    return fail("The attempt is dated " + dayOf(facts.begun_us) + " and lies in the future; today is " + dayOf(now_us) +
                " by this computer's clock. Check the clock, and add the attempt once it is over.");
  if (facts.curriculum.empty()) return {};
  const auto published = transaction.row("SELECT published_us FROM curricula WHERE name = ? AND version = ?",
                                         facts.curriculum, facts.curriculumVersion);
  if (!published || facts.begun_us >= published->number(0) - kClocksDiffer_us) return {};
  return fail("The attempt is dated " + dayOf(facts.begun_us) + ", and its level was published later, on " +
              dayOf(published->number(0)) + ". Keep it as free practice, or record an attempt at the level.");
}

}  // namespace insonate::store
