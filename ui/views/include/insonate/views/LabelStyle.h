#pragma once

namespace insonate::views {

/// Style in which labels are drawn over a slice.
struct LabelStyle {
  bool fill = true, outline = true;
  int thickness_px = 1;  ///< thickness of outlines, in logical pixels, 1 to 8
  bool operator==(const LabelStyle&) const = default;
};

}  // namespace insonate::views
