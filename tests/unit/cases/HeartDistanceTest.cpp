#include <insonate/cases/HeartDistance.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <string>

namespace insonate {
namespace {

CaseManifest withTarget(const std::string& name) {
  CaseManifest manifest;
  manifest.targets = {{name, kVein, {}}};
  return manifest;
}

TEST(HeartDistance, FollowsTheNameOfTheTarget) {
  EXPECT_EQ(siteAboveHeart_mm(withTarget("right internal jugular vein")), 150);
  EXPECT_EQ(siteAboveHeart_mm(withTarget("right axillary vein")), 150);
  EXPECT_EQ(siteAboveHeart_mm(withTarget("left basilic vein")), 120);
  EXPECT_EQ(siteAboveHeart_mm(withTarget("right common femoral vein")), -350);
  EXPECT_EQ(siteAboveHeart_mm(withTarget("V. saphena magna links")), -350);
}

TEST(HeartDistance, FollowsAVesselWithoutAKnownTarget) {
  CaseManifest manifest = withTarget("vein");
  EXPECT_EQ(siteAboveHeart_mm(manifest), 150) << "as in the neck";
  manifest.vessels.push_back({.name = "right external iliac vein", .label = kVein, .course = {}});
  manifest.vessels.push_back({.name = "right internal jugular vein", .label = kVein, .course = {}});
  EXPECT_EQ(siteAboveHeart_mm(manifest), -350) << "the first that is known";
}

}  // namespace
}  // namespace insonate
