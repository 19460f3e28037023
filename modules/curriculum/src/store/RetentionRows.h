#pragma once

#include "store/sql/Transaction.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate::store {

/// Returns the time this many calendar months before `now_us`, UTC.
std::int64_t monthsBefore(std::int64_t now_us, int months);
/// Returns the ids of ended attempts that began before a time.
std::vector<std::string> attemptsBefore(Transaction& transaction, std::int64_t time_us);
/// Returns the ids of ended attempts that began before a time and wait for their verification or their video.
std::vector<std::string> attemptsWithWorkBefore(Transaction& transaction, std::int64_t time_us);
/// Returns the time before which the recordings of attempts were deleted when the rule was last applied; empty if none
/// were.
std::optional<std::int64_t> recordingsDeletedBefore_us(Transaction& transaction);

}  // namespace insonate::store
