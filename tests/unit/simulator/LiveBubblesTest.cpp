#include "LiveProbe.h"

namespace insonate {
namespace {

using namespace std::chrono_literals;
using test::Live;

/// A vein without a name, in which bubbles stay at the tip. Neither probe nor blood moves.
TEST(LiveBubbles, AFlushIsShownAndFades) {
  Live live(test::poseAt(0));
  const test::Frame before = live.frameAt(test::poseAt(0));
  live.settle();
  live->setFlush(SalineFlush{.time_s = 1000, .wall = kVein, .from_mm = {0, 12, 0}});
  EXPECT_TRUE(live.until([&] { return test::greatestDifference(live->latest()->image, before->image) > 40; }, 60s));
  EXPECT_TRUE(live.until([&] { return live->latest()->image.gray == before->image.gray; }, 60s))
      << "as before the flush";
  std::this_thread::sleep_for(200ms);
  const std::uint64_t number = live->latest()->number;
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(live->latest()->number, number) << "nothing is computed without bubbles";
}

TEST(LiveBubbles, AnEndedAttemptTakesThemAway) {
  Live live(test::poseAt(0));
  const test::Frame before = live.frameAt(test::poseAt(0));
  live->setFlush(SalineFlush{.wall = kVein, .from_mm = {0, 12, 0}});
  EXPECT_TRUE(live.until([&] { return test::greatestDifference(live->latest()->image, before->image) > 40; }, 60s));
  live->setFlush(std::nullopt);
  EXPECT_TRUE(live.until([&] { return live->latest()->image.gray == before->image.gray; }, 2s));
}

}  // namespace
}  // namespace insonate
