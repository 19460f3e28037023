#pragma once

#include <cstdint>
#include <optional>

namespace insonate {

/// Converts the times that a sender states to CLOCK_MONOTONIC. The network delays messages by different times; the
/// message with the shortest delay of the last seconds gives the difference of the clocks. Poses then have the even
/// distances in time at which they were measured, from which velocities can be computed.
class SenderClock {
 public:
  /// Returns the time on CLOCK_MONOTONIC at which the sender measured a pose. `sent_ns`: time by the sender's clock; 0:
  /// unknown. `arrived_ns`: time of arrival, CLOCK_MONOTONIC. Never later than `arrived_ns`.
  std::int64_t localTime_ns(std::int64_t sent_ns, std::int64_t arrived_ns);

 private:
  std::int64_t windowBegan_ns_ = 0;
  std::optional<std::int64_t> offset_ns_, formerOffset_ns_;  ///< shortest delays of this and of the last window
};

}  // namespace insonate
