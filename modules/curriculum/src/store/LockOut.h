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

/// Returns the seconds until sign-in with a name may be tried again; 0: now.
///
/// Waiting time is measured by the computer's up time; after a restart, by the wall clock. If the clock was set back,
/// the wait starts again, so that the wait never exceeds an hour.
std::int64_t secondsLocked(Transaction& transaction, const std::string& name, const Moment& moment);
/// Counts a failure for a name. The count lasts until resetFailures(), or for a day without a failure.
void countFailure(Transaction& transaction, const std::string& name, const Moment& moment);
void resetFailures(Transaction& transaction, const std::string& name);

/// Returns secondsLocked(). If the result is 0, counts a failure at once, which resetFailures() takes back after a
/// success; simultaneous tries therefore gain nothing.
std::int64_t secondsLockedAfterTry(Transaction& transaction, const std::string& name, const Moment& moment);

/// The same limits for the network address of a browser. They are wider, since a class may share an address: 30
/// failures at once, and one more each minute.
std::int64_t secondsAddressLocked(Transaction& transaction, const std::string& address, const Moment& moment);
void countAddressFailure(Transaction& transaction, const std::string& address, const Moment& moment);
std::int64_t secondsAddressLockedAfterTry(Transaction& transaction, const std::string& address, const Moment& moment);
/// Takes back the failure that secondsAddressLockedAfterTry() has counted; other failures of the address still count.
void discountTry(Transaction& transaction, const std::string& address);

}  // namespace insonate::store
