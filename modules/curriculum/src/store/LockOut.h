#pragma once

#include "store/sql/Transaction.h"

#include <cstdint>
#include <string>

namespace insonate::store {

/// A moment by the clocks that lock-outs use.
struct Moment {
  std::int64_t now_us = 0, up_us = 0;
  std::string boot{};
};

/// Time for which a name is locked after this many consecutive failures: 30 s after the fifth, doubled by each further
/// one up to an hour.
std::int64_t lockAfter_us(std::int64_t failures);

/// Returns the seconds until a name may be tried again. 0: the name may be tried now, and the try is counted as a
/// failure until resetFailures(), so that many simultaneous tries gain nothing.
///
/// Until the computer is restarted, time is its up time. After a restart the clock's time is used; if the clock was set
/// back the wait starts again, so that it never exceeds an hour.
std::int64_t countTry(Transaction& transaction, const std::string& name, const Moment& moment);

void resetFailures(Transaction& transaction, const std::string& name);

}  // namespace insonate::store
