#include "session/AimWatch.h"

#include <insonate/procedure/Procedure.h>

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

NeedleAim aim(Vec3 tip_mm, Vec3 toward_mm) {
  static const auto grid = neck();
  Needle needle;
  needle.tip_mm = tip_mm, needle.direction = normalized(toward_mm - tip_mm);
  return aimOf(needle, *grid, {}, {});
}

TEST(AimWatch, TheFirstVesselOnTheAxisIsTheAim) {
  EXPECT_EQ(aim({-12, -3, 0}, {0, 12, 0}), NeedleAim::Vein);
  EXPECT_EQ(aim({24, -3, 0}, {12, 12, 0}), NeedleAim::Artery) << "before the vein behind it";
  EXPECT_EQ(aim({-12, -3, 0}, {0, 28, 0}), NeedleAim::Beside) << "it would pass behind the vein";
  EXPECT_EQ(aim({-12, -3, 0}, {12, -3, 0}), NeedleAim::Beside) << "along the skin";
}

TEST(AimWatch, InTheBodyANearMissIsAnAimSinceTissueMoves) {
  const Vec3 toward{-6, 30, 0};
  EXPECT_EQ(aim({-6, -3, 0}, toward), NeedleAim::Beside);
  EXPECT_EQ(aim({-6, 4, 0}, toward), NeedleAim::Vein);
  EXPECT_EQ(aim({-9, 4, 0}, {-9, 30, 0}), NeedleAim::Beside);
}

TEST(AimWatch, AnotherVeinBeforeTheTargetIsNotTheAim) {
  CaseManifest manifest;
  manifest.targets = {{"right internal jugular vein", kVein, {0, 12, 0}}};
  manifest.vessels = {{"right external jugular vein", kVein, {{{-17, 6, -50}, 2.5}, {{-17, 6, 50}, 2.5}}},
                      {"right internal jugular vein", kVein, {{{0, 12, -50}, 5}, {{0, 12, 50}, 5}}}};
  const VesselLocator names(manifest, *loadProcedure("internal_jugular"), {0, 0, 0});
  const auto aimWithNames = [&](Vec3 tip_mm, Vec3 toward_mm) {
    Needle needle;
    needle.tip_mm = tip_mm, needle.direction = normalized(toward_mm - tip_mm);
    return aimOf(needle, *neck(), names, {});
  };
  EXPECT_EQ(aimWithNames({-28, 0, 0}, {0, 12, 0}), NeedleAim::Beside) << "through the thin vein";
  EXPECT_EQ(aimWithNames({0, -3, 0}, {0, 12, 0}), NeedleAim::Vein);
}

TEST(AimWatch, AVesselThatEndsAtTheBorderOfTheGridIsNotMetBeyondIt) {
  EXPECT_EQ(aim({0, -3, 40}, {0, 12, 40}), NeedleAim::Beside);
}

}  // namespace
}  // namespace insonate
