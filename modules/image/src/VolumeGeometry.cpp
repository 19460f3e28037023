#include <insonate/image/VolumeGeometry.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace insonate {

Transform VolumeGeometry::patientFromIndex() const {
  Transform t{direction, origin_mm};
  for (int a = 0; a < 3; ++a) t.linear.column[a] = direction.column[a] * spacing_mm[a];
  return t;
}

Transform VolumeGeometry::indexFromPatient() const {
  return inverted(patientFromIndex());
}

Vec3 VolumeGeometry::center_mm() const {
  return patientFromIndex() * (Vec3{size[0] - 1.0, size[1] - 1.0, size[2] - 1.0} * 0.5);
}

bool sameGrid(const VolumeGeometry& a, const VolumeGeometry& b) {
  if (a.size != b.size) return false;
  const double tolerance_mm = 0.1 * std::min({a.spacing_mm.x, a.spacing_mm.y, a.spacing_mm.z});
  const Transform ta = a.patientFromIndex(), tb = b.patientFromIndex();
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 index{corner & 1 ? a.size[0] - 1.0 : 0.0, corner & 2 ? a.size[1] - 1.0 : 0.0,
                     corner & 4 ? a.size[2] - 1.0 : 0.0};
    if (norm(ta * index - tb * index) > tolerance_mm) return false;
  }
  return true;
}

Result<void> validate(const VolumeGeometry& g) {
  constexpr double kMaxVoxels = 4e9;
  double voxels = 1;
  for (int a = 0; a < 3; ++a) {
    if (g.size[a] < 1) return fail("The grid has " + std::to_string(g.size[a]) + " voxels along one axis.");
    if (!(g.spacing_mm[a] > 0) || !std::isfinite(g.spacing_mm[a]))
      return fail("The voxel spacing is " + std::to_string(g.spacing_mm[a]) +
                  " mm along one axis; it must be above 0.");
    voxels *= g.size[a];
  }
  if (voxels > kMaxVoxels) return fail("The grid has more voxels than Insonate can handle.");
  if (!isFinite(g.origin_mm)) return fail("The position of the first voxel is not a number.");
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const double expected = a == b ? 1 : 0;
      if (!(std::abs(dot(g.direction.column[a], g.direction.column[b]) - expected) < 1e-3))
        return fail("The axes of the grid are not at right angles; resample it to an orthogonal grid first.");
    }
  return {};
}

Result<void> checkVoxelSize(Vec3 spacing_mm) {
  constexpr double kSmallest_mm = 0.05, kLargest_mm = 25;
  for (int a = 0; a < 3; ++a) {
    const double size_mm = spacing_mm[a];
    if (size_mm >= kSmallest_mm && size_mm <= kLargest_mm) continue;
    if (!std::isfinite(size_mm))
      return fail("The distance of voxels along axis " + std::to_string(a + 1) +
                  " is not a number. Correct the spacing in the file.");
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.4g mm", size_mm);
    return fail("Voxels are " + std::string(text.data()) + " apart along axis " + std::to_string(a + 1) +
                (size_mm < kSmallest_mm ? "; no CT has such a small spacing. Are the values in meters?"
                                        : "; no CT has such a large spacing. Are the values in micrometers?") +
                " Correct the spacing in the file.");
  }
  return {};
}

}  // namespace insonate
