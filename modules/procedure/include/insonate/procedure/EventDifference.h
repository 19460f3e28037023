#pragma once

#include <cstdint>
#include <string>

namespace insonate {

/// A part of a recorded attempt that contradicts the recorded motion of probe and needle in the attempt's case.
struct EventDifference {
  std::int64_t time_us = 0;  ///< time since the recording began
  std::string what{};        ///< "needle event at 12.3 s"
  std::string recorded{}, expected{};

  bool operator==(const EventDifference&) const = default;
};

}  // namespace insonate
