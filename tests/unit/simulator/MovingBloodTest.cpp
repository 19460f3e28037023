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
  const auto neck = makePhantom(phantomVariants().front().name, 1);
  ASSERT_TRUE(neck);
  MovingBlood blood(neck->manifest.vessels);
  const BloodFlow& flow = blood.at({}, {}, {}, {});
  ASSERT_EQ(flow.tubes.size(), neck->manifest.vessels.size());
  int seen = 0;
  for (std::size_t v = 0; v < flow.tubes.size(); ++v) {
    const std::string& name = neck->manifest.vessels[v].name;
    const Vec3 direction = flow.tubes[v].course[flow.tubes[v].course.size() / 2].direction;
    const double lateral = direction.x * flow.tubes[v].course.front().position_mm.x;
    const auto has = [&](const char* part) { return name.find(part) != std::string::npos; };
    EXPECT_TRUE(!has("carotid") || direction.z > 0.5) << name;
    EXPECT_TRUE(!has("jugular") || direction.z < -0.5) << name;
    EXPECT_TRUE(!has("subclavian artery") || lateral > 0) << name;
    EXPECT_TRUE(!has("subclavian vein") || lateral < 0) << name;
    EXPECT_TRUE(!has("superior thyroid") || direction.z < 0) << name;
    seen += has("carotid");
  }
  EXPECT_EQ(seen, 6);
}

}  // namespace
}  // namespace insonate
