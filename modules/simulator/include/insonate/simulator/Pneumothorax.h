#pragma once

#include <algorithm>
#include <array>
#include <optional>

namespace insonate {

/// Air between lung and chest wall, after a needle has punctured the pleura. The air detaches the lung from the trachea
/// outward; the lung point moves away from the trachea until the whole lung is detached.
struct Pneumothorax {
  /// Speed of the lung point, and its largest distance from the trachea; our choice, by which the lung below the middle
  /// of the clavicle stops half a minute after the puncture.
  static constexpr double kGrowth_mmps = 3, kLargest_mm = 150;

  std::array<std::optional<double>, 2> since_s{};  ///< time of the puncture of the right and left lung; empty: none

  /// Returns LungMotion::detached_mm at a time.
  std::array<double, 2> detachedAt_mm(double time_s) const {
    std::array<double, 2> detached_mm{};
    for (std::size_t side = 0; side < since_s.size(); ++side)
      if (since_s[side]) detached_mm[side] = std::clamp((time_s - *since_s[side]) * kGrowth_mmps, 0.0, kLargest_mm);
    return detached_mm;
  }
  bool operator==(const Pneumothorax&) const = default;
};

}  // namespace insonate
