#include "MeshProbe.h"

#include <insonate/tissue/Labels.h>

namespace insonate::test {
namespace {

/// Directions turned about two axes; the third column flipped where `leftHanded`.
Mat3 obliqueDirections(bool leftHanded) {
  const double a = 0.6, b = -0.4;
  const Mat3 aboutZ{{Vec3{std::cos(a), std::sin(a), 0}, Vec3{-std::sin(a), std::cos(a), 0}, Vec3{0, 0, 1}}};
  const Mat3 aboutX{{Vec3{1, 0, 0}, Vec3{0, std::cos(b), std::sin(b)}, Vec3{0, -std::sin(b), std::cos(b)}}};
  Mat3 directions = aboutZ * aboutX;
  if (leftHanded) directions.column[2] = -directions.column[2];
  return directions;
}

class Grid : public testing::TestWithParam<bool> {
 protected:
  /// Oblique, anisotropic, far from the origin.
  LabelMap map() const {
    VolumeGeometry grid;
    grid.size = {60, 70, 30};
    grid.spacing_mm = {0.9, 0.8, 2};
    grid.origin_mm = {-310, 250, 1205};
    grid.direction = obliqueDirections(GetParam());
    return LabelMap(grid);
  }
};

TEST_P(Grid, ABallIsWhereItShouldBeAndFacesOutward) {
  for (const double detail_mm : {0.0, 1.0, 2.0}) {
    LabelMap labels = map();
    const Vec3 center = labels.geometry.center_mm() + Vec3{3, -2, 4};
    addBall(labels, kThyroid, center, 18);
    const Mesh mesh = surfaceOf(labels, kThyroid, {.smoothing_mm = 8, .detail_mm = detail_mm});
    EXPECT_TRUE(isClosed(mesh));
    EXPECT_NEAR(volume_mm3(mesh) / ballVolume_mm3(18), 1, 0.015) << "positive, too: triangles face outward";
    EXPECT_NEAR(area_mm2(mesh) / ballArea_mm2(18), 1, 0.03);
    EXPECT_LT(norm(centroid(mesh) - center), 0.2);
    EXPECT_GT(worstOutward(mesh, center), 0.8);
  }
}

TEST_P(Grid, OneVoxelOfAnObliqueGridIsAtItsCenter) {
  LabelMap labels = map();
  labels.at(7, 61, 29) = kNerve;
  const Mesh mesh = surfaceOf(labels, kNerve);
  EXPECT_LT(norm(centroid(mesh) - labels.geometry.patientFromIndex() * Vec3{7, 61, 29}), 1e-3);
  EXPECT_GT(volume_mm3(mesh), 0);
}

INSTANTIATE_TEST_SUITE_P(OfEitherHandedness, Grid, testing::Bool(),
                         [](const auto& handed) { return handed.param ? "LeftHanded" : "RightHanded"; });

}  // namespace
}  // namespace insonate::test
