#include <insonate/cases/HeartDirection.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <string>

namespace insonate {
namespace {

NamedVessel vessel(const std::string& name, Vec3 first_mm, Vec3 last_mm, double radius_mm = 4, Label label = kVein) {
  return {name, label, {{first_mm, radius_mm}, {(first_mm + last_mm) * 0.5, radius_mm}, {last_mm, radius_mm}}};
}

CaseManifest withVessels(std::vector<NamedVessel> vessels) {
  CaseManifest manifest;
  manifest.vessels = std::move(vessels);
  return manifest;
}

TEST(HeartDirection, FollowsTheNameOfTheVein) {
  const struct {
    const char* name;
    Vec3 first, last, toward;
  } veins[] = {
      {"right internal jugular vein", {0, 0, 50}, {0, 0, 0}, {0, 0, -1}},
      {"left internal jugular vein", {0, 0, 0}, {0, 0, 50}, {0, 0, -1}},
      {"right common femoral vein", {0, 0, 0}, {0, 0, 50}, {0, 0, 1}},
      {"right basilic vein", {0, 0, 50}, {0, 0, 0}, {0, 0, 1}},
      {"right axillary vein", {-90, 0, 0}, {-40, 0, 0}, {1, 0, 0}},
      {"left axillary vein", {40, 0, 0}, {90, 0, 0}, {-1, 0, 0}},
  };
  for (const auto& vein : veins) {
    const auto toward = veinTowardHeart(withVessels({vessel(vein.name, vein.first, vein.last)}), vein.first);
    ASSERT_TRUE(toward) << vein.name;
    EXPECT_NEAR(norm(*toward - vein.toward), 0, 1e-9) << vein.name;
  }
}

TEST(HeartDirection, AnUnknownVeinLeadsIntoTheLargerOne) {
  const NamedVessel trunk = vessel("trunk", {0, 0, 40}, {0, 0, -40}, 8);
  const NamedVessel branch = vessel("branch", {0, 0, -10}, {40, 0, -12}, 3);
  const auto toward = veinTowardHeart(withVessels({trunk, branch}), {30, 0, -11});
  ASSERT_TRUE(toward);
  EXPECT_LT(toward->x, -0.99);
}

TEST(HeartDirection, TakesTheNearestVeinAndNoArtery) {
  const auto toward = veinTowardHeart(withVessels({vessel("right internal jugular vein", {0, 0, 50}, {0, 0, 0}),
                                                   vessel("right common femoral vein", {0, 0, -400}, {0, 0, -350}),
                                                   vessel("femoral artery", {5, 0, -400}, {5, 0, -350}, 4, kArtery)}),
                                      {5, 0, -380});
  ASSERT_TRUE(toward);
  EXPECT_GT(toward->z, 0.99);
}

TEST(HeartDirection, ACaseWithoutNamedVeinsKnowsItByItsTarget) {
  CaseManifest manifest;
  EXPECT_FALSE(veinTowardHeart(manifest, {}));
  manifest.targets = {{"left internal jugular vein", kVein, {}}, {"femoral vein", kVein, {0, 0, -400}}};
  EXPECT_EQ(veinTowardHeart(manifest, {0, 0, 10}), (Vec3{0, 0, -1}));
  EXPECT_EQ(veinTowardHeart(manifest, {0, 0, -390}), (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace insonate
