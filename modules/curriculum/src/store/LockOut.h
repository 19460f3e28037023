#pragma once

#include "store/sql/Transaction.h"

#include <cstdint>
#include <string>

namespace insonate::store {

/// Time by the clocks from which the locking of names after failed sign-ins is computed.
struct Moment {
  std::int64_t now_us = 0, up_us = 0;
  std::string boot{};
};

/// Returns the time for which a sign-in name is locked after this many consecutive failures: 30 s after the fifth
/// failure; the time doubles with each further failure, up to an hour.
std::int64_t lockAfter_us(std::int64_t failures);

/// Returns the seconds until sign-in with a name may be tried again. If the result is 0, the sign-in may be tried now,
/// and the try counts as a failure until resetFailures(), so that simultaneous tries gain nothing.
///
/// Waiting time is measured by the computer's up time; after a restart, by the wall clock. If the clock was set back,
/// the wait starts again, so that the wait never exceeds an hour.
std::int64_t secondsLockedAfterTry(Transaction& transaction, const std::string& name, const Moment& moment);

/// Does the same for the network address of a browser. The limit is wider, since a class may share an address: 30 wrong
/// passwords at once, and one more each minute.
std::int64_t secondsAddressLockedAfterTry(Transaction& transaction, const std::string& address, const Moment& moment);
/// Removes a try with the right password from the count of this address; tries with wrong passwords still count.
void discountTry(Transaction& transaction, const std::string& address);

void resetFailures(Transaction& transaction, const std::string& name);

}  // namespace insonate::store
