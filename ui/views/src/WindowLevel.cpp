#include <insonate/views/WindowLevel.h>

#include <algorithm>
#include <cmath>

namespace insonate::views {

std::uint8_t WindowLevel::gray(double hu) const {
  const double share = (hu - level_HU) / std::max(1.0, window_HU) + 0.5;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

std::span<const WindowLevelPreset> windowLevelPresets() {
  static constexpr WindowLevelPreset kPresets[] = {
      {"soft tissue", {350, 50}}, {"bone", {1000, 400}}, {"lung", {1500, -600}},
      {"abdomen", {350, 40}},     {"brain", {100, 50}},
  };
  return kPresets;
}

}  // namespace insonate::views
