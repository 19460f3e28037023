#include "LiveProbe.h"
#include "support/Allocations.h"

namespace insonate {
namespace {

using namespace std::chrono_literals;
using test::Frame;
using test::greatestDifference;
using test::Live;
using test::poseAt;

/// In the plane of a probe at x = 0, its tip on the vein's front wall, `z_mm` off the slice.
Needle inPlane(double z_mm = 0) {
  Needle needle;
  needle.tip_mm = {0, 7, z_mm};
  needle.direction = normalized({1, 1, 0});
  needle.bevelNormal = {0, -1, 0};
  return needle;
}

Tenting tentOf(const Needle& needle, double depth_mm) {
  return {needle.tip_mm, needle.direction, depth_mm, 3};
}

/// The image that has this needle.
Frame frameWith(Live& live, const std::optional<Needle>& needle, const std::optional<Tenting>& tenting = {}) {
  const std::uint64_t before = live->latest()->number;
  live->setNeedle(needle, tenting);
  Frame frame;
  EXPECT_TRUE(live.until([&] { return (frame = live->latest())->number > before && frame->needle == needle; }));
  return frame;
}

TEST(LiveNeedle, MakesAPictureByItselfAndGoesWithoutATrace) {
  Live live;
  const Frame without = live.frameAt(poseAt(0));
  live.settle();
  const Frame with = frameWith(live, inPlane());
  EXPECT_GT(greatestDifference(with->image, without->image), 50);
  EXPECT_EQ(with->patientFromProbe, without->patientFromProbe);
  const Frame off = frameWith(live, inPlane(9));
  EXPECT_EQ(off->image.gray, without->image.gray) << "far from the slice";
  EXPECT_EQ(frameWith(live, {})->image.gray, without->image.gray);
}

TEST(LiveNeedle, HeldStillMakesNoMorePictures) {
  Live live;
  live.frameAt(poseAt(0));
  live.settle();
  frameWith(live, inPlane());
  live.settle();
  const Frame frame = live->latest();
  for (int i = 0; i < 50; ++i) live->setNeedle(inPlane());
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(live->latest(), frame);
}

TEST(LiveNeedle, DentsTheTissueUntilTheWallGivesWay) {
  Live live;
  live.frameAt(poseAt(0));
  live.settle();
  const Frame before = frameWith(live, inPlane(9));
  const Frame dented = frameWith(live, inPlane(9.01), tentOf(inPlane(), 3));
  EXPECT_GT(greatestDifference(dented->image, before->image), 30);
  EXPECT_EQ(frameWith(live, inPlane(9))->image.gray, before->image.gray) << "it springs back";
}

TEST(LiveNeedle, DentsPressedTissueToo) {
  ImagingSetup setup = test::smallSetup();
  setup.mechanics = {};
  setup.mechanics.settings.mesh_mm = 1;
  const Transform pressed = *patientFromProbe({0, 2.5, 0}, {0, 1, 0}, {1, 0, 0});
  Live live(pressed, setup);
  live.frameAt(pressed);
  EXPECT_TRUE(live.until([&] { return live->latest()->press.settled; }));
  live.settle();
  const Frame before = live->latest();
  EXPECT_GT(before->press.force_N, 0);
  const Frame dented = frameWith(live, inPlane(9), tentOf(inPlane(), 3));
  EXPECT_GT(greatestDifference(dented->image, before->image), 30);
}

TEST(LiveNeedle, ThatIsNoneIsIgnored) {
  Live live;
  live.frameAt(poseAt(0));
  live.settle();
  const Frame frame = live->latest();
  Needle needle = inPlane();
  needle.radius_mm = -1;
  live->setNeedle(needle);
  needle = inPlane();
  needle.tip_mm.x = std::nan("");
  live->setNeedle(needle);
  live->setNeedle(inPlane(), Tenting{{0, 0, 0}, {0, 1, 0}, std::nan(""), 3});
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(live->latest(), frame);
}

/// A wire in the vein below the probe at x = 0, along the image, `z_mm` off the slice.
SharedRods wireInVein(double z_mm) {
  FlexibleRod wire;
  for (double x = -10; x <= 10; x += 2) wire.nodes_mm.push_back({x, 12, z_mm});
  return std::make_shared<const std::vector<FlexibleRod>>(std::vector{wire});
}

TEST(LiveRods, ShowGoAndDoNotDisturbAStillImage) {
  Live live;
  const Frame without = live.frameAt(poseAt(0));
  live.settle();
  const auto frameWithRods = [&](const SharedRods& rods) {
    const std::uint64_t before = live->latest()->number;
    live->setRods(rods);
    Frame frame;
    EXPECT_TRUE(live.until([&] { return (frame = live->latest())->number > before && frame->rods == rods; }));
    return frame;
  };
  EXPECT_GT(greatestDifference(frameWithRods(wireInVein(0))->image, without->image), 50);
  EXPECT_EQ(frameWithRods(wireInVein(9))->image.gray, without->image.gray) << "far from the slice";
  const SharedRods same = wireInVein(0);
  frameWithRods(same);
  live.settle();
  const Frame still = live->latest();
  live->setRods(same);
  FlexibleRod bad;
  live->setRods(std::make_shared<const std::vector<FlexibleRod>>(std::vector{bad}));
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(live->latest(), still) << "neither the same rods nor one without nodes make an image";
  EXPECT_EQ(frameWithRods({})->image.gray, without->image.gray);
}

TEST(LiveNeedle, MovingAsksForNoMemory) {
  LiveOptions options;
  options.workAhead = false;  // scenes to come are made of memory
  options.cineBytes = 300'000;
  Live live(poseAt(0), test::smallSetup(), options);
  live.frameAt(poseAt(0));
  live.settle();
  const auto move = [&](int from, int to) {
    for (int i = from; i < to; ++i) frameWith(live, inPlane(0.01 * i), tentOf(inPlane(0.01 * i), 2));
  };
  move(0, 60);
  const long before = test::allocations();
  move(60, 80);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace insonate
