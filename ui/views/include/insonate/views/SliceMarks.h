#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/views/SceneOptions.h>

#include <optional>
#include <vector>

namespace insonate::views {

/// Marks over a slice: those of a tool, and instruments in the body. Patient space (LPS, mm). Marks more than 1 mm from
/// the slice are not drawn. For the brush, the intersection of the brush with the slice is drawn; for a path, the part
/// near the slice, and a disc where it crosses the slice.
struct SliceMarks {
  struct Brush {
    Vec3 center_mm;
    double radius_mm = 1;
    bool flat = false;  ///< true: the brush is a circle in this slice; false: a sphere
  };
  std::vector<Vec3> points_mm;
  std::vector<Vec3> line_mm;
  std::optional<Brush> brush;
  std::vector<ScenePath> paths;
};

}  // namespace insonate::views
