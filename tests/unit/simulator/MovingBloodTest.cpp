#include <insonate/cases/Phantom.h>
#include <insonate/simulator/MovingBlood.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

TEST(MovingBlood, TissueMovesAgainstTheProbe) {
  Transform later;
  later.offset = {0, 0, 2};
  const Vec3 velocity = tissueVelocity_mmps({}, later, 0.1, 20);
  EXPECT_NEAR(velocity.z, -20, 1e-9);
  EXPECT_NEAR(velocity.x, 0, 1e-9);
  EXPECT_EQ(tissueVelocity_mmps({}, later, 0, 20), Vec3{});
}

/// The directions of flow in the built-in neck, whose center lines begin at either end.
TEST(MovingBlood, FlowsTowardTheHeadInArteriesAndTowardTheHeartInVeinsOfTheBuiltInNeck) {
  const auto neck = makePhantom(phantomVariants().front().name, kPhantomSeed);
  ASSERT_TRUE(neck);
  MovingBlood blood(neck->manifest.vessels);
  const BloodFlow& flow = blood.at({}, {}, {}, {});
  ASSERT_EQ(flow.tubes.size(), neck->manifest.vessels.size());
  int seen = 0;
  for (std::size_t v = 0; v < flow.tubes.size(); ++v) {
    const std::string& name = neck->manifest.vessels[v].name;
    const Vec3 direction = flow.tubes[v].course[flow.tubes[v].course.size() / 2].direction;
    const double lateral = direction.x * flow.tubes[v].course.front().position_mm.x;
    if (name.find("carotid") != std::string::npos) EXPECT_GT(direction.z, 0.5) << name;
    if (name.find("jugular") != std::string::npos) EXPECT_LT(direction.z, -0.5) << name;
    if (name.find("subclavian artery") != std::string::npos) EXPECT_GT(lateral, 0) << name;
    if (name.find("subclavian vein") != std::string::npos) EXPECT_LT(lateral, 0) << name;
    if (name.find("superior thyroid") != std::string::npos) EXPECT_LT(direction.z, 0) << name;
    seen += name.find("carotid") != std::string::npos;
  }
  EXPECT_EQ(seen, 6);
}

}  // namespace
}  // namespace insonate
