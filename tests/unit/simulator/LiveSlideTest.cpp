#include "LiveProbe.h"

#include <insonate/ultrasound/FrameCost.h>

#include <cmath>

namespace insonate {
namespace {

using namespace test;

/// Along the slab and back, turning, tilted, and lifted off the skin in between.
Transform onTheWay(int step) {
  const double x_mm = 75 * std::sin(0.21 * step), turn = 0.13 * step, tilt = 0.3 * std::sin(0.5 * step);
  const double lifted_mm = step % 7 == 3 ? 2.5 : 0;
  return *patientFromProbe({x_mm, -lifted_mm, 4 * std::cos(0.3 * step)}, {std::sin(tilt), std::cos(tilt), 0},
                           {std::cos(turn), 0, std::sin(turn)});
}

double relativeDifference(const EnvelopeFrame& a, const EnvelopeFrame& b) {
  double difference2 = 0, power = 0;
  EXPECT_EQ(a.amplitude.size(), b.amplitude.size());
  for (std::size_t n = 0; n < std::min(a.amplitude.size(), b.amplitude.size()); ++n) {
    difference2 += std::pow(double(a.amplitude[n]) - b.amplitude[n], 2);
    power += std::pow(double(a.amplitude[n]), 2);
  }
  return std::sqrt(difference2 / power);
}

TEST(LiveSlide, EveryPictureIsThatOfAFreshScene) {
  LiveOptions options;
  options.sceneMargin_mm = 6, options.sceneReserve_mm = 3;
  Live live(onTheWay(0), smallSetup(), options);
  const auto patient = wideCase();
  for (int step = 0; step < 40; ++step) {
    const Frame frame = live.frameAt(onTheWay(step));
    ASSERT_TRUE(frame);
    EXPECT_LE(greatestDifference(frame->image, freshPicture(*patient, smallSetup(), onTheWay(step))), 1) << step;
  }
  EXPECT_GE(live->status().scenesBuilt, 15);
}

TEST(LiveSlide, ScenesOfWhatWasMadeAheadAreTheSame) {
  const auto patient = wideCase();
  const ImagingSetup setup = smallSetup();
  const auto source = makeSceneSource(*patient);
  auto imager = Imager::make(setup);
  ASSERT_TRUE(source && imager);
  const Region everywhere{{-120, -30, -40}, {120, 60, 40}};
  int made = 0;
  while ((*source)->precompute(everywhere, sceneDetail_mm(setup.probe, setup.settings))) ++made;
  EXPECT_GE(made, 2) << "pictures below must cross from one part to the next";
  ImagingFrame fresh, ahead;
  for (double x_mm = 20; x_mm <= 36; x_mm += 4) {
    const Region region = regionOf(setup.probe, setup.settings, poseAt(x_mm));
    const auto one = makeScene(*patient, setup, region), other = makeScene(**source, setup, region);
    ASSERT_TRUE(one && other);
    imager->render(**one, poseAt(x_mm), fresh);
    imager->render(**other, poseAt(x_mm), ahead);
    EXPECT_LT(relativeDifference(fresh.envelope, ahead.envelope), 1e-3) << x_mm;
    EXPECT_LE(greatestDifference(fresh.image, ahead.image), 1) << x_mm;
  }
}

TEST(LiveSlide, WorkAheadStopsWhenTold) {
  const auto patient = wideCase();
  const auto source = makeSceneSource(*patient);
  ASSERT_TRUE(source);
  const Region everywhere{{-120, -30, -40}, {120, 60, 40}};
  int asked = 0;
  EXPECT_FALSE((*source)->precompute(everywhere, 0.7, [&] { return ++asked > 0; }));
  EXPECT_GT(asked, 0);
  EXPECT_FALSE((*source)->precompute({{500, 500, 500}, {600, 600, 600}}, 0.7)) << "nothing lies there";
}

}  // namespace
}  // namespace insonate
