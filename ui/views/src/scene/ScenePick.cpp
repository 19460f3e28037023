#include "ScenePick.h"

#include <algorithm>
#include <cmath>

namespace insonate::views {

std::optional<ScenePick> firstVisible(const LabelMap& labels, Vec3 from_mm, Vec3 to_mm,
                                      const std::array<bool, 256>& visible,
                                      const std::optional<ClippingPlane>& clipping) {
  const VolumeGeometry& grid = labels.geometry;
  const Transform indexFromPatient = grid.indexFromPatient();
  const Vec3 start = indexFromPatient * from_mm, way = indexFromPatient * to_mm - start;
  // The part of the ray within the grid, as shares of its length.
  double first = 0, last = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = -0.5 - start[axis], high = grid.size[axis] - 0.5 - start[axis];
    if (std::abs(way[axis]) < 1e-12) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    first = std::max(first, std::min(low / way[axis], high / way[axis]));
    last = std::min(last, std::max(low / way[axis], high / way[axis]));
  }
  const double finest_mm = std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
  const double step = 0.25 * finest_mm / norm(to_mm - from_mm);
  for (double share = first; share <= last; share += step) {
    const std::uint8_t label = sampleNearest(labels, start + way * share);
    if (!visible[label]) continue;
    const Vec3 at_mm = from_mm + (to_mm - from_mm) * share;
    if (clipping && dot(at_mm - clipping->point_mm, clipping->normal) < 0) continue;
    return ScenePick{at_mm, label};
  }
  return std::nullopt;
}

}  // namespace insonate::views
