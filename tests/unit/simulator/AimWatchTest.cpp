#include "session/AimWatch.h"

#include <insonate/procedure/Procedure.h>
#include <insonate/simulator/ProbePose.h>

#include <gtest/gtest.h>

#include <cmath>

namespace insonate {
namespace {

/// Skin at y = 0; along z, a vein at x = 0 and an artery at x = 12, both 12 mm deep, and a thin vein at x = -17, 6 mm
/// deep.
std::shared_ptr<const TissueGrid> neck() {
  VolumeGeometry grid;
  grid.size = {61, 41, 31};
  grid.origin_mm = {-30, -6, -15};
  LabelMap labels(grid);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 6; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        labels.at(i, j, k) = std::hypot(i - 30, j - 18) < 5 || std::hypot(i - 13, j - 12) < 2.5 ? kVein
                             : std::hypot(i - 42, j - 18) < 4                                   ? kArtery
                             : j < 8                                                            ? kSkin
                                                                                                : kSoftTissue;
  return *TissueGrid::fromLabels(labels);
}

/// An image of a probe whose face is on the skin, with a needle from `tip_mm`. The probe has moved the tissue of the
/// image by `aside_mm` along x.
LiveFrame imageOf(Vec3 tip_mm, Vec3 toward_mm, double aside_mm = 0) {
  LiveFrame frame;
  frame.patientFromProbe = *patientFromProbe({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  Needle needle;
  needle.tip_mm = tip_mm, needle.direction = normalized(toward_mm - tip_mm);
  frame.needle = needle;
  frame.press.displacement = {
      .left_mm = -30, .top_mm = -5, .step_mm = 30, .columns = 3, .rows = 3, .restFromDisplayed = {}, .lung = {}};
  frame.press.displacement.restFromDisplayed.assign(9, {static_cast<float>(-aside_mm), 0});
  return frame;
}

NeedleAim aim(const LiveFrame& frame, double tent_mm = 0) {
  static const auto grid = neck();
  return aimOf(frame, tent_mm, *grid, {}, {});
}

NeedleAim aim(Vec3 tip_mm, Vec3 toward_mm) {
  return aim(imageOf(tip_mm, toward_mm));
}

TEST(AimWatch, TheFirstVesselOnTheAxisIsTheAim) {
  EXPECT_EQ(aim({-12, -3, 0}, {0, 12, 0}), NeedleAim::Vein);
  EXPECT_EQ(aim({24, -3, 0}, {12, 12, 0}), NeedleAim::Artery) << "before the vein behind it";
  EXPECT_EQ(aim({-12, -3, 0}, {0, 28, 0}), NeedleAim::Beside) << "it would pass behind the vein";
  EXPECT_EQ(aim({-12, -3, 0}, {12, -3, 0}), NeedleAim::Beside) << "along the skin";
  EXPECT_EQ(aim(LiveFrame{}), NeedleAim::Unknown) << "no needle";
}

TEST(AimWatch, AGrazedVeinIsNotTheAim) {
  for (const double tip_mm : {-3, 4, 9}) {
    EXPECT_EQ(aim({-6, tip_mm, 0}, {-6, 30, 0}), NeedleAim::Beside) << tip_mm;
    EXPECT_EQ(aim({-4.8, tip_mm, 0}, {-4.8, 30, 0}), NeedleAim::Beside) << tip_mm;
    EXPECT_EQ(aim({-3.5, tip_mm, 0}, {-3.5, 30, 0}), NeedleAim::Vein) << tip_mm;
  }
}

TEST(AimWatch, TheVeinIsWhereTheProbeHasMovedIt) {
  const auto straightAt = [](double x_mm) { return imageOf({x_mm, 2, 0}, {x_mm, 30, 0}, -7); };
  EXPECT_EQ(aim(straightAt(0)), NeedleAim::Beside) << "the vein was here before the compression";
  EXPECT_EQ(aim(straightAt(-7)), NeedleAim::Vein);
  EXPECT_EQ(aim(straightAt(5)), NeedleAim::Artery);
}

TEST(AimWatch, AnIndentedWallIsStillAhead) {
  EXPECT_EQ(aim(imageOf({0, 12.5, 0}, {0, 30, 0}), 5.5), NeedleAim::Vein) << "the tip pushes the wall ahead";
  EXPECT_EQ(aim(imageOf({-5, 12, 0}, {-5, 30, 0}), 0.5), NeedleAim::Beside) << "the tip pushes the vein aside";
}

TEST(AimWatch, AnotherVeinBeforeTheTargetIsNotTheAim) {
  CaseManifest manifest;
  manifest.targets = {{"right internal jugular vein", kVein, {0, 12, 0}}};
  manifest.vessels = {{"right external jugular vein", kVein, {{{-17, 6, -50}, 2.5}, {{-17, 6, 50}, 2.5}}},
                      {"right internal jugular vein", kVein, {{{0, 12, -50}, 5}, {{0, 12, 50}, 5}}}};
  const VesselLocator names(manifest, *loadProcedure("internal_jugular"), {0, 0, 0});
  const auto aimWithNames = [&](Vec3 tip_mm, Vec3 toward_mm) {
    return aimOf(imageOf(tip_mm, toward_mm), 0, *neck(), names, {});
  };
  EXPECT_EQ(aimWithNames({-28, 0, 0}, {0, 12, 0}), NeedleAim::Beside) << "through the thin vein";
  EXPECT_EQ(aimWithNames({0, -3, 0}, {0, 12, 0}), NeedleAim::Vein);
}

TEST(AimWatch, AVesselThatEndsAtTheBorderOfTheGridIsNotMetBeyondIt) {
  EXPECT_EQ(aim({0, -3, 40}, {0, 12, 40}), NeedleAim::Beside);
}

}  // namespace
}  // namespace insonate
