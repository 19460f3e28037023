#pragma once

#include "store/sql/Transaction.h"

#include <cstdint>
#include <string>

namespace insonate::store {

/// A moment by the clocks that a lock-out asks.
struct Moment {
  std::int64_t now_us = 0, up_us = 0;
  std::string boot{};
};

/// Time for which a name is locked after this many consecutive failures: 30 s after the fifth, doubled by each further
/// one up to an hour.
std::int64_t lockAfter_us(std::int64_t failures);

/// Seconds until a name may be tried again; 0: now, and the try is counted as a failure until resetFailures(), so that
/// many simultaneous tries gain nothing.
///
/// Within one start of the computer, time is its up time. After a restart it is the clock's; if the clock was set back
/// the wait starts again, so that it stays within an hour.
std::int64_t countTry(Transaction& transaction, const std::string& name, const Moment& moment);

void resetFailures(Transaction& transaction, const std::string& name);

}  // namespace insonate::store
