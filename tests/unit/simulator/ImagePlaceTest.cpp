#include <insonate/simulator/ImagePlace.h>
#include <insonate/simulator/ProbePose.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate {
namespace {

/// An image 40 mm wide and 30 mm deep of a probe at the origin, which looks along y.
LiveFrame frameAtOrigin() {
  LiveFrame frame;
  frame.image.width = 401, frame.image.height = 301;
  frame.image.pixel_mm = 0.1, frame.image.left_mm = -20, frame.image.top_mm = 0;
  frame.patientFromProbe = *patientFromProbe({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  return frame;
}

TEST(ImagePlace, AMoveOfTheWholeImageCountsByItsDistance) {
  const LiveFrame frame = frameAtOrigin();
  EXPECT_TRUE(showsPlaceOf(frame, frame.patientFromProbe));
  for (const Vec3 way : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}) {
    EXPECT_TRUE(showsPlaceOf(frame, *patientFromProbe(way * (kSamePlace_mm - 0.1), {0, 1, 0}, {1, 0, 0})));
    EXPECT_FALSE(showsPlaceOf(frame, *patientFromProbe(way * (kSamePlace_mm + 0.1), {0, 1, 0}, {1, 0, 0})));
  }
}

/// The deep corners are 30 mm below the face: a tilt by the angle a moves them by 60 mm sin(a / 2).
TEST(ImagePlace, ATiltCountsByTheDeepestCorner) {
  const LiveFrame frame = frameAtOrigin();
  const auto tilted = [](double rad) {
    return *patientFromProbe({0, 0, 0}, {0, std::cos(rad), std::sin(rad)}, {1, 0, 0});
  };
  const double limit_rad = 2 * std::asin(kSamePlace_mm / 60);
  EXPECT_TRUE(showsPlaceOf(frame, tilted(limit_rad - 0.01)));
  EXPECT_FALSE(showsPlaceOf(frame, tilted(limit_rad + 0.01)));
}

TEST(ImagePlace, ATurnByHalfARevolutionIsAnotherPlace) {
  const LiveFrame frame = frameAtOrigin();
  EXPECT_FALSE(showsPlaceOf(frame, *patientFromProbe({0, 0, 0}, {0, 1, 0}, {-1, 0, 0})));
}

}  // namespace
}  // namespace insonate
