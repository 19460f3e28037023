#include "LiveProbe.h"

namespace insonate {
namespace {

using namespace std::chrono_literals;
using test::Live;

constexpr double kOverLung_mm = 60;

/// Tissue without vessels over two lungs.
std::shared_ptr<const PatientCase> lungCase() {
  auto patient = std::make_shared<PatientCase>(*test::wideCase());
  const VolumeGeometry& grid = patient->labels.geometry;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 12; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        patient->labels.at(i, j, k) = j > 22 && std::abs(i - 100) > 30 ? kAirway : kSoftTissue;
  return patient;
}

LiveOptions breathing() {
  LiveOptions options;
  options.pulsating = true;
  return options;
}

/// The lung moves although neither probe nor vessels do.
TEST(LiveLung, ImagesFollowTheSlidingLung) {
  Live live(test::poseAt(kOverLung_mm), test::smallSetup(), breathing(), lungCase());
  const test::Frame first = live.frameAt(test::poseAt(kOverLung_mm));
  EXPECT_TRUE(live.until([&] { return live->latest()->number > first->number + 20; }, 60s));
  EXPECT_TRUE(live.until([&] { return test::greatestDifference(live->latest()->image, first->image) > 20; }, 60s));
}

TEST(LiveLung, NothingMovesWithAPneumothorax) {
  LiveOptions options = breathing();
  options.physiology.lungSlide_mm = 0;
  Live live(test::poseAt(kOverLung_mm), test::smallSetup(), options, lungCase());
  live.frameAt(test::poseAt(kOverLung_mm));
  live.settle();
  std::this_thread::sleep_for(200ms);
  const std::uint64_t number = live->latest()->number;
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(live->latest()->number, number);
}

/// A needle has punctured the left lung: within some seconds the lung under the probe, 60 mm beside the trachea, stops.
TEST(LiveLung, APneumothoraxGrowsAndStopsTheLungUnderTheProbe) {
  Live live(test::poseAt(kOverLung_mm), test::smallSetup(), breathing(), lungCase());
  const test::Frame first = live.frameAt(test::poseAt(kOverLung_mm));
  EXPECT_TRUE(first->trachea_mm);
  live->setPneumothorax({false, true});
  bool isStill = false;
  for (int tries = 0; tries < 200 && !isStill; ++tries) {
    const test::Frame before = live->latest();
    ASSERT_TRUE(live.until([&] { return live->latest()->number > before->number + 15; }, 60s));
    isStill = live->latest()->image.gray == before->image.gray;
  }
  EXPECT_TRUE(isStill);
}

}  // namespace
}  // namespace insonate
