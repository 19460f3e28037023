#include "Womersley.h"

#include <gtest/gtest.h>

namespace insonate {
namespace {

double meanOverArea(const std::array<std::complex<double>, BloodTube::kProfile>& profile, bool imaginary) {
  // Simpson's rule over 2 x dx; the number of intervals is even.
  constexpr int kLast = BloodTube::kProfile - 1;
  double sum = 0;
  for (int i = 0; i <= kLast; ++i) {
    const double x = double(i) / kLast, weight = i == 0 || i == kLast ? 1 : i % 2 ? 4 : 2;
    sum += weight * 2 * x * (imaginary ? profile[i].imag() : profile[i].real());
  }
  return sum / (3 * kLast);
}

TEST(Womersley, HasUnitMeanAndIsZeroAtTheWall) {
  for (const double alpha : {0.0, 0.5, 3.0, 8.0}) {
    const auto profile = womersleyProfile(alpha);
    EXPECT_NEAR(meanOverArea(profile, false), 1, 2e-3) << alpha;
    EXPECT_NEAR(meanOverArea(profile, true), 0, 2e-3) << alpha;
    EXPECT_NEAR(std::abs(profile.back()), 0, 1e-9) << alpha;
  }
}

TEST(Womersley, IsAParabolaWhenSlowAndFlatWhenFast) {
  const auto slow = womersleyProfile(0.1), fast = womersleyProfile(30);
  for (int i = 0; i < BloodTube::kProfile; ++i) {
    const double x = double(i) / (BloodTube::kProfile - 1);
    EXPECT_NEAR(slow[i].real(), 2 * (1 - x * x), 1e-3);
    if (x < 0.8) {
      EXPECT_NEAR(std::abs(fast[i]), 1.05, 0.03);
    }
  }
  EXPECT_EQ(womersleyProfile(200).front(), womersleyProfile(40).front());
}

TEST(Womersley, ACarotidArteryHasANumberOfAboutFive) {
  EXPECT_NEAR(womersleyNumber(3.1, 2 * 3.14159265 * 70 / 60), 4.6, 0.1);
}

}  // namespace
}  // namespace insonate
