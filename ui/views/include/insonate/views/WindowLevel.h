#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace insonate::views {

/// Display window: Hounsfield units from level - window/2 (black) to level + window/2 (white). The window is at least
/// 1.
struct WindowLevel {
  double window_HU = 350, level_HU = 50;
  constexpr bool operator==(const WindowLevel&) const = default;

  /// Returns the gray value, 0 to 255.
  std::uint8_t gray(double hu) const;
};

struct WindowLevelPreset {
  std::string_view name;
  WindowLevel value;
};

/// Returns presets with values that are common in radiology: soft tissue, bone, lung, abdomen, brain.
std::span<const WindowLevelPreset> windowLevelPresets();

}  // namespace insonate::views
