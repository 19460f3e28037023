#include <insonate/views/SlicePlane.h>
#include <insonate/views/WindowLevel.h>

#include <gtest/gtest.h>

#include <cmath>

namespace insonate::views {
namespace {

std::string letters(SliceKind kind) {
  const SliceAxes axes = sliceAxes(kind);
  return orientationLetters(-axes.right) + " " + orientationLetters(axes.right) + " " + orientationLetters(axes.up) +
         " " + orientationLetters(-axes.up);
}

TEST(SlicePlane, LettersFollowRadiologicalConvention) {
  // Left, right, top, bottom of the display.
  EXPECT_EQ(letters(SliceKind::Axial), "R L A P");
  EXPECT_EQ(letters(SliceKind::Coronal), "R L H F");
  EXPECT_EQ(letters(SliceKind::Sagittal), "A P H F");
}

TEST(SlicePlane, LettersOfOblique) {
  EXPECT_EQ(orientationLetters({-0.8, -0.6, 0}), "RA");
  EXPECT_EQ(orientationLetters({0.1, 0, 1}), "H");
  EXPECT_EQ(orientationLetters({1, 1.1, 1.2}), "HPL");
}

TEST(SlicePlane, TheSideOfThePatientIsThatOfTheNearestAxis) {
  EXPECT_EQ(patientSide({1, 0, 0}), "L");
  EXPECT_EQ(patientSide({-0.8, 0.3, 0.7}), "R");
  EXPECT_EQ(patientSide({-0.7, 0.3, 0.8}), "Head");
  EXPECT_EQ(patientSide({0, 0.1, -1}), "Foot");
  EXPECT_EQ(patientSide({0.1, -1, 0}), "A");
  EXPECT_EQ(patientSide({0.1, 1, 0}), "P");
}

TEST(SlicePlane, ObliqueIsTheProbesPicture) {
  const Transform patientFromProbe{{{Vec3{0, 0, 1}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}}}, {10, 20, 30}};
  const SliceAxes axes = sliceAxes(SliceKind::Oblique, patientFromProbe);
  EXPECT_EQ(axes.right, (Vec3{0, 0, 1}));
  EXPECT_EQ(axes.up, (Vec3{0, -1, 0}));
}

TEST(SlicePlane, DisplayAndPatientAreInverse) {
  const SlicePlane plane{sliceAxes(SliceKind::Coronal), {10, -20, 30}, 0.4, 801, 600};
  const Vec3 point = plane.patientFromDisplay({123.25, 456.5});
  const DisplayPoint back = plane.displayFromPatient(point);
  EXPECT_NEAR(back.x, 123.25, 1e-9);
  EXPECT_NEAR(back.y, 456.5, 1e-9);
  EXPECT_NEAR(plane.distance_mm(point + Vec3{0, 3, 0}), 3, 1e-9);
}

TEST(SlicePlane, StepIsTheGridsWhereItsAxesAgree) {
  VolumeGeometry grid;
  grid.spacing_mm = {0.5, 0.6, 3};
  EXPECT_DOUBLE_EQ(sliceStep_mm(grid, {0, 0, 1}), 3);
  EXPECT_DOUBLE_EQ(sliceStep_mm(grid, {0, -1, 0}), 0.6);
  EXPECT_DOUBLE_EQ(sliceStep_mm(grid, {0, std::sqrt(0.5), std::sqrt(0.5)}), 0.5);
}

TEST(SlicePlane, WindowAndLevel) {
  const WindowLevel soft{350, 50};
  EXPECT_EQ(soft.gray(-125), 0);
  EXPECT_EQ(soft.gray(50), 128);
  EXPECT_EQ(soft.gray(225), 255);
  EXPECT_EQ(soft.gray(-1000), 0);
  EXPECT_EQ(soft.gray(3000), 255);
}

}  // namespace
}  // namespace insonate::views
