#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>

#include <cstdint>

namespace insonate::store {

/// Accepted difference between the clocks of two computers.
inline constexpr std::int64_t kClocksDiffer_us = 600'000'000;

/// Fails if an attempt begins or ends later than `now_us`, or begins before its curriculum was published in this
/// store; a version that is not published here is not checked.
Result<void> refuseImpossibleDates(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us);

}  // namespace insonate::store
