#include <insonate/cases/Phantom.h>
#include <insonate/simulator/MovingBlood.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <algorithm>

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

/// The tissue below 5 mm is compressed between two images, and then stays.
TEST(MovingBlood, CompressingAVeinAugmentsItsFlowForAMoment) {
  NamedVessel vein{"right internal jugular vein", kVein, {}};
  for (int i = -20; i <= 20; ++i) vein.course.push_back({{0, 0, 20.0}, 5}), vein.course.back().position_mm.y = 3.0 * i;
  const NamedVessel vessels[] = {vein};
  MovingBlood blood(vessels);
  const auto compressed = [](double factor) {
    PlaneDisplacement d{-20, 0, 0.5, 81, 81, {}};
    for (int row = 0; row < d.rows; ++row)
      for (int column = 0; column < d.columns; ++column)
        d.restFromDisplayed.push_back({0, float(std::max(0.0, 0.5 * row - 5) * (1 / factor - 1))});
    return d;
  };
  const auto fastest = [](const BloodFlow& flow) {
    double most = 0;
    for (const BloodTube::Point& point : flow.tubes[0].course) most = std::max(most, point.scale);
    return most;
  };
  Physiology still;
  still.heartRate_perMin = still.breathing_perMin = 0;
  blood.next(still, {}, compressed(1), {}, 0);
  const double squeezed = fastest(blood.next(still, {}, compressed(0.6), {}, 0.03));
  double later = 0;
  for (int image = 0; image < 20; ++image) later = fastest(blood.next(still, {}, compressed(0.6), {}, 0.03));
  EXPECT_GT(squeezed, 1.5 * later);
  blood.next(still, {}, compressed(1), {}, 0.03);
  EXPECT_NEAR(fastest(blood.next(still, {}, compressed(0.6), {}, 0)), later, 0.02) << "no image came before";
  EXPECT_NEAR(later, fastest(blood.at(still, {}, compressed(0.6), {})), 0.02);
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
