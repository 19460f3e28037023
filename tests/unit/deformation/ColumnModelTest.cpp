#include "ColumnRig.h"

#include <gmock/gmock.h>

namespace insonate::test {
namespace {

using Column = ColumnRig;

TEST_F(Column, OneLayerIsShortenedEvenly) {
  plane.press_mm = 5;  // 45 mm of tissue on 40
  const Deformation answer = solved();
  ASSERT_TRUE(answer.moved);
  EXPECT_TRUE(answer.converged);
  for (const double z_mm : {0.0, 10.0, 25.0, 39.5, 40.0})
    EXPECT_NEAR(restOf(answer, middle(answer), rowAt(answer, z_mm)), 40 - (40 - z_mm) * 45 / 40, 1e-5) << z_mm;
}

TEST_F(Column, ForceIsPressureTimesWidthTimesFootprint) {
  plane.press_mm = 5;
  // 10 kPa * 5/45 in the middle; the profile is as wide as the face, and 3.5 standard deviations hold 0.9995 of it.
  EXPECT_NEAR(solved().force_N, 10.0 * 5 / 45 * 38 * 10 * 1e-3 * 0.9995, 1e-4);
  face.footprint_mm = 20;
  EXPECT_NEAR(solved().force_N, 10.0 * 5 / 45 * 38 * 20 * 1e-3 * 0.9995, 2e-4);
}

TEST_F(Column, LayersShareAsTheirCompliances) {
  plane.press_mm = 4;
  plane.layers = {{2, kSkin}, {10, kFat}, {8, kMuscle}};  // then 24 mm of soft tissue down to the bottom
  const double compliance = 2.0 / 100 + 10.0 / 4 + 8.0 / 25 + 24.0 / 10;
  const double pressure_kPa = 4 / compliance;  // equation 1
  const Deformation answer = solved();
  const int column = middle(answer);
  double seen_mm = 40;
  EXPECT_NEAR(forward(answer, column, 16), seen_mm -= 24 * (1 - pressure_kPa / 10), 1e-5);
  EXPECT_NEAR(forward(answer, column, 8), seen_mm -= 8 * (1 - pressure_kPa / 25), 1e-5);
  EXPECT_NEAR(forward(answer, column, -2), seen_mm -= 10 * (1 - pressure_kPa / 4), 1e-5);
  EXPECT_NEAR(forward(answer, column, -4), seen_mm -= 2 * (1 - pressure_kPa / 100), 1e-5);
  EXPECT_NEAR(seen_mm, 0, 1e-9);  // the skin is at the face
  const std::size_t cell = std::size_t(rowAt(answer, 20)) * (answer.meshColumns - 1) + column;
  EXPECT_NEAR(answer.pressure_kPa[cell], pressure_kPa, 0.002);
}

TEST_F(Column, SkinFollowsTheNormalProfile) {
  plane.press_mm = 6;
  const Deformation answer = solved();
  const double sd_mm = 38 / std::sqrt(2 * M_PI);
  for (int c = 0; c < answer.displacement.columns; c += 7) {
    const double x_mm = answer.displacement.left_mm + c * answer.displacement.step_mm;
    EXPECT_NEAR(forward(answer, c, -6), -6 + 6 * std::exp(-x_mm * x_mm / (2 * sd_mm * sd_mm)), 1e-4) << x_mm;
  }
}

TEST_F(Column, InfiniteLayersKeepTheirLengthExactly) {
  plane.press_mm = 5;
  plane.layers = {{10, kSoftTissue}, {12, kBone}};
  const Deformation answer = solved();
  const int column = middle(answer);
  EXPECT_NEAR(forward(answer, column, 17) - forward(answer, column, 5), 12, 1e-5);
  const double pressure_kPa = 5 / (10.0 / 10 + 23.0 / 10);
  EXPECT_NEAR(forward(answer, column, 17), 40 - 23 * (1 - pressure_kPa / 10), 1e-5);
}

TEST_F(Column, AllInfiniteTissueDoesNotMove) {
  plane.below = kBone;
  plane.press_mm = 5;
  const Deformation pressed = solved();
  EXPECT_FALSE(pressed.moved);
  EXPECT_FALSE(pressed.converged);  // the face cannot be where it was asked to be
  EXPECT_TRUE(pressed.displacement.empty());
  plane.press_mm = -3;
  const Deformation forced = solved(4);
  EXPECT_FALSE(forced.moved);
  EXPECT_EQ(forced.force_N, 4);
  EXPECT_NEAR(forced.faceShift_mm, 3, 1e-6);
}

TEST_F(Column, AnInfiniteColumnStandsBesideColumnsThatMove) {
  plane.press_mm = 5;
  plane.blocks = {{10, 0, 15, 100, kBone}};
  const Deformation answer = solved();
  const int rigid = middle(answer) + 25;  // x = 12.5
  for (int r = 0; r < answer.displacement.rows; ++r) EXPECT_NEAR(restOf(answer, rigid, r), seenZ(answer, r), 1e-9);
  EXPECT_TRUE(answer.moved);
}

TEST_F(Column, ForceAndIndentationAreEachOthersInverse) {
  plane.layers = {{1.5, kSkin}, {7, kFat}};
  plane.circles = {{0, 18, 5, kVein}};
  for (const double press_mm : {0.5, 3.0, 8.0}) {
    plane.press_mm = press_mm;
    const Deformation byIndentation = solved();
    const Deformation byForce = solved(byIndentation.force_N);
    EXPECT_NEAR(byForce.faceShift_mm, 0, 1e-6);
    EXPECT_NEAR(byForce.force_N, byIndentation.force_N, 1e-9);
    for (std::size_t i = 0; i < byForce.mesh.size(); i += 101)
      EXPECT_NEAR(byForce.mesh[i].z_mm, byIndentation.mesh[i].z_mm, 1e-5);
  }
}

TEST_F(Column, TheFaceMovesToTheSkinAndThenIn) {
  plane.press_mm = -6;  // the face hangs over the skin
  const Deformation answer = solved(0.5);
  const double pressure_kPa = 0.5 / (38 * 10 * 1e-3 * 0.9995);
  EXPECT_NEAR(answer.faceShift_mm, 6 + 34 * pressure_kPa / 10, 1e-3);
  EXPECT_NEAR(answer.force_N, 0.5, 1e-9);
}

TEST_F(Column, MoreForcePressesDeeper) {
  plane.layers = {{1.5, kSkin}, {7, kFat}};
  plane.circles = {{-4, 15, 4, kVein}, {8, 20, 3, kArtery}};
  double last_mm = 0, vein_mm2 = 1e9;
  for (double force_N = 0.05; force_N < 10; force_N *= 1.7) {
    const Deformation answer = solved(force_N);
    EXPECT_GT(answer.faceShift_mm, last_mm) << force_N;
    last_mm = answer.faceShift_mm;
    ASSERT_EQ(answer.lumens.size(), 2u);
    EXPECT_LE(answer.lumens[1].area_mm2, vein_mm2);
    vein_mm2 = answer.lumens[1].area_mm2;
  }
}

TEST_F(Column, LumensAreMeasuredInThePlane) {
  plane.press_mm = 4;
  plane.circles = {{-4, 15, 4, kVein}, {8, 20, 3, kArtery}};
  const Deformation answer = solved();
  ASSERT_EQ(answer.lumens.size(), 2u);
  EXPECT_EQ(answer.lumens[0].label, kArtery);
  EXPECT_NEAR(answer.lumens[0].rest_mm2, M_PI * 9, 1.5);
  EXPECT_NEAR(answer.lumens[1].rest_mm2, M_PI * 16, 1.5);
  EXPECT_LT(answer.lumens[1].area_mm2, 0.95 * answer.lumens[1].rest_mm2);
  EXPECT_GT(answer.lumens[0].area_mm2, 0.98 * answer.lumens[0].rest_mm2);
}

TEST_F(Column, ALumenIsASpringOfTableOne) {
  tissues.tissues[kVein] = {.kind = Mechanics::Lumen, .pressure_kPa = 0.5};
  plane.layers = {{10, kSoftTissue}, {8, kVein}};
  plane.press_mm = 4;
  const double pressure_kPa = 4 / (36.0 / 10 + 8.0 / 23);
  const Deformation answer = solved();
  EXPECT_NEAR(forward(answer, middle(answer), 14), 40 - 26 * (1 - pressure_kPa / 10), 1e-5);
  EXPECT_NEAR(forward(answer, middle(answer), 6), forward(answer, middle(answer), 14) - 8 * (1 - pressure_kPa / 23),
              1e-5);
}

TEST_F(Column, TheBottomDoesNotMove) {
  plane.press_mm = 9;
  plane.circles = {{0, 20, 6, kVein}};
  const Deformation answer = solved();
  const PlaneDisplacement& d = answer.displacement;
  ASSERT_NEAR(seenZ(answer, d.rows - 1), 40, 1e-9);
  for (int c = 0; c < d.columns; ++c) EXPECT_EQ(d.restFromDisplayed[std::size_t(d.rows - 1) * d.columns + c].z_mm, 0);
}

TEST_F(Column, InverseOfForwardWithinATenthOfAMicrometreOfThePoint) {
  plane.skinRadius_mm = 70;
  plane.press_mm = 7.3;  // no whole number of cells
  plane.layers = {{1.7, kSkin}, {6.1, kFat}};
  plane.circles = {{-3, 17, 6, kVein}, {9, 22, 3.3, kArtery}};
  plane.blocks = {{-30, 30, 30, 36, kBone}};
  const Deformation answer = solved();
  int checked = 0;
  for (int c = 0; c < answer.displacement.columns; ++c)
    for (int r = 0; r < answer.displacement.rows; ++r) {
      const double rest_mm = restOf(answer, c, r);
      const double x_mm = answer.displacement.left_mm + c * answer.displacement.step_mm;
      if (plane.of(x_mm, rest_mm + plane.press_mm).skin_mm > -1) continue;  // the skin cuts a cell of the mesh
      EXPECT_NEAR(forward(answer, c, rest_mm), seenZ(answer, r), 1e-4);
      ++checked;
    }
  EXPECT_GT(checked, 10000);
}

}  // namespace
}  // namespace insonate::test
