#include <insonate/curriculum/Statistics.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace insonate {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kTiny = 1e-6;

// Figures of intervals come from Python 3.11 with mpmath 1.3 at 30 digits: quantiles by bisection of
// mpmath.betainc(), gammainc() and ncdf(), the bootstrap by adding up all n^n samples instead of drawing some.

TEST(Statistics, MeanWithItsTInterval) {
  const std::vector<double> times_s{41, 52.5, 48, 60, 55.5, 47, 63, 58, 50.5, 44};
  const auto mean = meanOf(times_s, ValueKind::NotNegative);
  ASSERT_TRUE(mean && mean->interval);
  EXPECT_EQ(mean->basis, "t");
  EXPECT_NEAR(mean->value, 51.95, kTiny);
  EXPECT_NEAR(mean->interval->low, 46.826187, kTiny);
  EXPECT_NEAR(mean->interval->high, 57.073812, kTiny);
  // t(9, 0.95) = 1.833113 (tables) instead of t(9, 0.975) = 2.262157.
  EXPECT_NEAR(meanOf(times_s, ValueKind::NotNegative, 0.9)->interval->high, 51.95 + 5.123812 * 1.833113 / 2.262157,
              1e-5);
}

TEST(Statistics, CountsHavePoissonsInterval) {
  const auto none = meanOf(std::vector<double>(10, 0.0), ValueKind::Count);
  ASSERT_TRUE(none && none->interval);
  EXPECT_EQ(none->basis, "Poisson");
  EXPECT_EQ(none->interval->low, 0) << "not below";
  EXPECT_NEAR(none->interval->high, 0.36888795, kTiny);
  const auto four = meanOf(std::vector<double>{0, 1, 0, 0, 2, 0, 1, 0}, ValueKind::Count);
  EXPECT_EQ(four->value, 0.5);
  EXPECT_NEAR(four->interval->low, 0.13623317, kTiny);
  EXPECT_NEAR(four->interval->high, 1.28019858, kTiny);
  const auto two = meanOf(std::vector<double>{1, 1}, ValueKind::Count);
  EXPECT_NEAR(two->interval->low, 0.12110463, kTiny);
  EXPECT_NEAR(two->interval->high, 3.61234383, kTiny);
}

TEST(Statistics, YesAndNoHaveWilsonsInterval) {
  const auto three = meanOf(std::vector<double>{1, 0, 1, 1}, ValueKind::YesNo);
  ASSERT_TRUE(three && three->interval);
  EXPECT_EQ(three->basis, "Wilson");
  EXPECT_NEAR(three->interval->low, 0.30064184, kTiny);
  EXPECT_NEAR(three->interval->high, 0.95441274, kTiny);
}

TEST(Statistics, FewOrTiedValuesHaveABootstrapIntervalInTheirRange) {
  const auto few = meanOf(std::vector<double>{20, 3, 9, 2, 5}, ValueKind::NotNegative);
  ASSERT_TRUE(few && few->interval);
  EXPECT_EQ(few->basis, "bootstrap");
  EXPECT_NEAR(few->interval->low, 2.2, 0.21) << "the t interval would begin at -1.2";
  EXPECT_NEAR(few->interval->high, 17.8, 0.61);
  const auto skewed = meanOf(std::vector<double>{0, 0, 1.5, 2, 4, 90}, ValueKind::NotNegative);
  EXPECT_NEAR(skewed->interval->low, 0.25, 0.1);
  EXPECT_NEAR(skewed->interval->high, 60.67, 1);
  const auto shares = meanOf(std::vector<double>{100, 100, 95, 80, 99, 100, 100}, ValueKind::Percent);
  EXPECT_NEAR(shares->interval->low, 87.86, 0.5);
  EXPECT_EQ(shares->interval->high, 100) << "not above";
  const auto again = meanOf(std::vector<double>{5, 2, 9, 20, 3}, ValueKind::NotNegative);
  EXPECT_EQ(again->interval->low, few->interval->low) << "the same values, whatever their order";
  // Means of counts are no counts.
  EXPECT_EQ(meanOf(std::vector<double>{0.5, 1, 0.25, 0, 0}, ValueKind::Count)->basis, "bootstrap");
}

TEST(Statistics, WhyThereIsNoIntervalIsSaid) {
  const auto two = meanOf(std::vector<double>{30, 60}, ValueKind::NotNegative);
  ASSERT_TRUE(two);
  EXPECT_EQ(two->value, 45);
  EXPECT_FALSE(two->interval);
  EXPECT_EQ(two->basis, "fewer than 5 values");
  const auto alike = meanOf(std::vector<double>(6, 100.0), ValueKind::Percent);
  EXPECT_FALSE(alike->interval);
  EXPECT_EQ(alike->basis, "all values are equal");
}

TEST(Statistics, IntervalsHoldTheTruthAsOftenAsTheySayAndStayInTheirRange) {
  std::mt19937 random(3);
  const auto unit = [&] { return (random() + 0.5) / 4294967296.0; };
  const auto heldShare = [&](std::size_t n, ValueKind kind, double truth, const std::function<double()>& draw) {
    int held = 0;
    constexpr int kRuns = 300;
    for (int run = 0; run < kRuns; ++run) {
      std::vector<double> values(n);
      std::ranges::generate(values, draw);
      const auto mean = meanOf(values, kind);
      if (!mean->interval) continue;
      const Interval range = rangeOf(kind);
      EXPECT_TRUE(mean->interval->low >= range.low && mean->interval->high <= range.high);
      EXPECT_TRUE(mean->interval->low <= mean->value && mean->value <= mean->interval->high);
      held += mean->interval->low <= truth && truth <= mean->interval->high;
    }
    return held / double(kRuns);
  };
  // Uniform between 0 and 100: mean 50; exponential: mean 20.
  EXPECT_GT(heldShare(6, ValueKind::Percent, 50, [&] { return 100 * unit(); }), 0.92);
  EXPECT_GT(heldShare(25, ValueKind::Percent, 50, [&] { return 100 * unit(); }), 0.92);
  EXPECT_GT(heldShare(8, ValueKind::NotNegative, 20, [&] { return -20 * std::log(unit()); }), 0.85)
      << "few of a skewed distribution are known to be too narrow";
  EXPECT_GT(heldShare(8, ValueKind::Count, 0.3, [&] { return unit() < 0.3 ? 1.0 : 0.0; }), 0.95);
}

TEST(Statistics, DeviationKeepsItsDigitsFarFromZero) {
  // 30 for values 4, 7, 13, 16, whatever they are shifted by (Welford's example).
  EXPECT_NEAR(*standardDeviation(std::vector<double>{1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}), std::sqrt(30.0), 1e-9);
}

TEST(Statistics, QuantilesAreOfType7) {
  const std::vector<double> values{4, 1, 3, 2};  // place 0.25 * 3 = 0.75 between 1 and 2
  EXPECT_DOUBLE_EQ(*quantile(values, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(*quantile(values, 0.75), 3.25);
  EXPECT_DOUBLE_EQ(*median(values), 2.5);
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 1), 4);
  EXPECT_EQ(median(std::vector<double>{9}), 9);
}

TEST(Statistics, WilsonsInterval) {
  // z = 1.959964, p = 0.8, n = 10: middle (0.8 + 0.192073) / 1.384146 = 0.716740, half 0.226578.
  const auto eight = proportion(8, 10);
  ASSERT_TRUE(eight && eight->interval);
  EXPECT_EQ(eight->value, 0.8);
  EXPECT_NEAR(eight->interval->low, 0.490162, kTiny);
  EXPECT_NEAR(eight->interval->high, 0.943318, kTiny);
  // None of ten: from 0 to z^2 / (n + z^2) = 3.841459 / 13.841459.
  EXPECT_EQ(proportion(0, 10)->interval->low, 0);
  EXPECT_NEAR(proportion(0, 10)->interval->high, 0.277533, kTiny);
  EXPECT_DOUBLE_EQ(proportion(10, 10)->interval->high, 1);
}

TEST(Statistics, MovingMeansAreOfTheLastThatAreThere) {
  const std::vector<std::optional<double>> values{1, 2, 3, std::nullopt, 5, 6};
  EXPECT_THAT(movingMean(values, 3), testing::ElementsAre(1, 1.5, 2, std::nullopt, 4, 5.5));
  EXPECT_THAT(movingMean(values, 0), testing::Each(std::nullopt));
  EXPECT_TRUE(movingMean({}, 3).empty());
}

TEST(Statistics, BoxPlotAfterTukey) {
  // Quartiles 2 and 4: whiskers reach at most from -1 to 7, 100 is beyond.
  const auto box = boxPlotOf(std::vector<double>{100, 1, 4, 2, 3});
  ASSERT_TRUE(box);
  EXPECT_EQ(box->lowerQuartile, 2);
  EXPECT_EQ(box->median, 3);
  EXPECT_EQ(box->upperQuartile, 4);
  EXPECT_EQ(box->lowerWhisker, 1);
  EXPECT_EQ(box->upperWhisker, 4);
  EXPECT_EQ(box->outliers, std::vector<double>{100});
  EXPECT_EQ(boxPlotOf(std::vector<double>{5, 5})->upperWhisker, 5);
}

TEST(Statistics, PercentileRankHalvesTies) {
  const std::vector<double> values{1, 2, 2, 4};
  EXPECT_EQ(percentileRank(values, 2), 50);  // (1 + 2 / 2) / 4
  EXPECT_EQ(percentileRank(values, 0), 0);
  EXPECT_EQ(percentileRank(values, 9), 100);
}

TEST(Statistics, WhereThereIsNothingThereIsNoValue) {
  for (const std::vector<double>& values :
       {std::vector<double>{}, {1, kNaN}, {std::numeric_limits<double>::infinity()}}) {
    EXPECT_FALSE(meanOf(values, ValueKind::Any));
    EXPECT_FALSE(meanValue(values));
    EXPECT_FALSE(standardDeviation(values));
    EXPECT_FALSE(quantile(values, 0.5));
    EXPECT_FALSE(boxPlotOf(values));
    EXPECT_FALSE(percentileRank(values, 1));
  }
  EXPECT_FALSE(standardDeviation(std::vector<double>{1}));
  EXPECT_FALSE(quantile(std::vector<double>{1, 2}, 1.1));
  EXPECT_FALSE(quantile(std::vector<double>{1, 2}, kNaN));
  EXPECT_FALSE(meanOf(std::vector<double>{1, 2}, ValueKind::Any, 1.0));
  EXPECT_FALSE(meanOf(std::vector<double>{1e308, 1e308, 1e308}, ValueKind::Any));
  EXPECT_FALSE(proportion(0, 0));
  EXPECT_FALSE(proportion(3, 2));
  EXPECT_FALSE(proportion(-1, 2));
}

}  // namespace
}  // namespace insonate
