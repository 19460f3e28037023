#pragma once

#include <insonate/segmentation/Region.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace insonate::test {

struct ToolGrid {
  std::string name;
  VolumeGeometry geometry;
};

/// About 40 mm of the patient around the origin, in grids of all kinds.
inline std::vector<ToolGrid> toolGrids() {
  const auto made = [](std::string name, Vec3 spacing_mm, const Mat3& direction) {
    VolumeGeometry g;
    g.spacing_mm = spacing_mm;
    g.direction = direction;
    for (int a = 0; a < 3; ++a) g.size[a] = static_cast<int>(40 / spacing_mm[a]) + 1;
    g.origin_mm = -g.center_mm();
    return ToolGrid{std::move(name), g};
  };
  const double c = std::cos(0.4), s = std::sin(0.4);
  const Mat3 oblique{{Vec3{c, s, 0}, Vec3{-s * 0.8, c * 0.8, 0.6}, Vec3{s * 0.6, -c * 0.6, 0.8}}};
  const Mat3 mirrored{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  const Mat3 lying{{Vec3{0, 1, 0}, Vec3{0, 0, -1}, Vec3{1, 0, 0}}};
  return {made("isotropic", {1, 1, 1}, {}), made("anisotropic", {0.7, 0.7, 2.5}, {}),
          made("oblique", {0.8, 1.1, 1.6}, oblique), made("left-handed", {0.9, 0.9, 1.7}, mirrored),
          made("other axes", {2, 0.8, 1.2}, lying)};
}

class OnGrids : public testing::TestWithParam<ToolGrid> {
 protected:
  const VolumeGeometry& grid() const { return GetParam().geometry; }
  /// Voxels whose center in the patient is `in`.
  template <class In>
  Selection shape(const In& in) const {
    Selection chosen(grid(), boxOf(grid()));
    const Transform patientFromIndex = grid().patientFromIndex();
    for (int k = 0; k < grid().size[2]; ++k)
      for (int j = 0; j < grid().size[1]; ++j)
        for (int i = 0; i < grid().size[0]; ++i)
          chosen.mask.at(i, j, k) = in(patientFromIndex * Vec3{double(i), double(j), double(k)});
    return chosen;
  }
  Selection ball(Vec3 center_mm, double radius_mm) const {
    return shape([=](Vec3 p) { return norm(p - center_mm) <= radius_mm; });
  }
  double volume_mm3(const Selection& chosen) const {
    return double(chosen.count()) * grid().spacing_mm.x * grid().spacing_mm.y * grid().spacing_mm.z;
  }
};

/// Voxels in which two selections of one grid differ, wherever their boxes are.
inline std::size_t difference(const Selection& a, const Selection& b) {
  const VoxelBox all = united(a.box, b.box);
  std::size_t count = 0;
  for (int k = all.first[2]; k < all.end[2]; ++k)
    for (int j = all.first[1]; j < all.end[1]; ++j)
      for (int i = all.first[0]; i < all.end[0]; ++i) count += a.isSelected(i, j, k) != b.isSelected(i, j, k);
  return count;
}

inline std::string nameOfGrid(const testing::TestParamInfo<ToolGrid>& info) {
  std::string name;
  for (const char letter : info.param.name)
    if (std::isalpha(static_cast<unsigned char>(letter))) name += letter;
  return name;
}

}  // namespace insonate::test

#define INSONATE_ON_GRIDS(suite) \
  INSTANTIATE_TEST_SUITE_P(Grids, suite, testing::ValuesIn(insonate::test::toolGrids()), insonate::test::nameOfGrid)
