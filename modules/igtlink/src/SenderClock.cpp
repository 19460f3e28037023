#include "SenderClock.h"

#include <algorithm>

namespace insonate {
namespace {

constexpr std::int64_t kWindow_ns = 5'000'000'000;
/// A longer delay is a sign that the sender's clock was set.
constexpr std::int64_t kMaxDelay_ns = 1'000'000'000;

}  // namespace

std::int64_t SenderClock::localTime_ns(std::int64_t sent_ns, std::int64_t arrived_ns) {
  if (sent_ns == 0) return arrived_ns;
  const std::int64_t offset_ns = arrived_ns - sent_ns;
  if (arrived_ns - windowBegan_ns_ > kWindow_ns) {
    windowBegan_ns_ = arrived_ns;
    formerOffset_ns_ = offset_ns_;
    offset_ns_.reset();
  }
  offset_ns_ = std::min(offset_ns, offset_ns_.value_or(offset_ns));
  const std::int64_t shortest_ns = std::min(*offset_ns_, formerOffset_ns_.value_or(*offset_ns_));
  if (offset_ns - shortest_ns > kMaxDelay_ns) {
    offset_ns_ = offset_ns;
    formerOffset_ns_.reset();
    return arrived_ns;
  }
  return sent_ns + shortest_ns;
}

}  // namespace insonate
