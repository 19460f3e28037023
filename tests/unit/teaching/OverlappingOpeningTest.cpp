#include <insonate/teaching/OverlappingOpening.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

constexpr std::int64_t kNow_us = 1000;

TestOpening from1500To2000() {
  return {.id = "a", .curriculum = "course", .level = "test", .start_us = 1500, .end_us = 2000};
}

bool overlaps(const TestOpening& opening, std::optional<std::int64_t> start_us, std::optional<std::int64_t> end_us) {
  const NewOpening fresh{.curriculum = "course", .level = "test", .start_us = start_us, .end_us = end_us};
  return overlappingOpening({opening}, fresh, kNow_us) != nullptr;
}

TEST(OverlappingOpening, PeriodsOverlapIfEachBeginsBeforeTheOtherEnds) {
  const TestOpening later = from1500To2000();
  EXPECT_TRUE(overlaps(later, 1600, 1700));
  EXPECT_TRUE(overlaps(later, {}, 1501)) << "from now on";
  EXPECT_FALSE(overlaps(later, {}, 1500)) << "an end is no time of the period";
  EXPECT_TRUE(overlaps(later, 1999, {}));
  EXPECT_FALSE(overlaps(later, 2000, {}));
  TestOpening endless = later;
  endless.end_us.reset();
  EXPECT_TRUE(overlaps(endless, 1'000'000, {}));
}

TEST(OverlappingOpening, OtherTestsAndOpeningsThatAreOverDoNotCount) {
  TestOpening other = from1500To2000();
  other.level = "another test";
  EXPECT_FALSE(overlaps(other, {}, {}));
  TestOpening closed = from1500To2000();
  closed.closed_us = 900;
  EXPECT_FALSE(overlaps(closed, {}, {}));
  TestOpening ended = from1500To2000();
  ended.start_us = 0, ended.end_us = 999;
  EXPECT_FALSE(overlaps(ended, 0, {}));
}

}  // namespace
}  // namespace insonate
