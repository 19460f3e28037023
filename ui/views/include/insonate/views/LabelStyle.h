#pragma once

namespace insonate::views {

/// Look of labels over a slice.
struct LabelStyle {
  bool fill = true, outline = true;
  int thickness_px = 1;  ///< of outlines, device-independent, 1..8
  bool operator==(const LabelStyle&) const = default;
};

}  // namespace insonate::views
