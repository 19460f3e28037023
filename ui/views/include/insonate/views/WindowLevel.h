#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace insonate::views {

/// Hounsfield units from level - window/2 (black) to level + window/2 (white). The window is at least 1.
struct WindowLevel {
  double window_HU = 350, level_HU = 50;
  constexpr bool operator==(const WindowLevel&) const = default;

  /// 0..255.
  std::uint8_t grey(double hu) const;
};

struct WindowLevelPreset {
  std::string_view name;
  WindowLevel value;
};

/// Soft tissue first, then bone, lung, abdomen, brain: the values radiologists know.
std::span<const WindowLevelPreset> windowLevelPresets();

}  // namespace insonate::views
