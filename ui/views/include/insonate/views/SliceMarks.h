#pragma once

#include <insonate/core/Vec3.h>

#include <optional>
#include <vector>

namespace insonate::views {

/// Marks of a tool over a slice. Places are in the patient, LPS mm; marks farther than a millimeter from the slice are
/// left out, but for the brush, of which the section is drawn.
struct SliceMarks {
  struct Brush {
    Vec3 centre_mm;
    double radius_mm = 1;
    bool flat = false;  ///< a circle in this slice only
  };
  std::vector<Vec3> points_mm;
  std::vector<Vec3> line_mm;
  std::optional<Brush> brush;
};

}  // namespace insonate::views
