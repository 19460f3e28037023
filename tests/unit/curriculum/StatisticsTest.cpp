#include <insonate/curriculum/Statistics.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace insonate {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kTiny = 1e-6;

TEST(Statistics, MeanWithItsTInterval) {
  // s^2 = (4 + 1 + 0 + 1 + 4) / 4 = 2.5; t(4, 0.975) = 2.776445 (tables); half = 2.776445 sqrt(2.5 / 5) = 1.963243.
  const auto mean = meanOf(std::vector<double>{1, 2, 3, 4, 5});
  ASSERT_TRUE(mean && mean->interval);
  EXPECT_EQ(mean->value, 3);
  EXPECT_NEAR(mean->interval->low, 3 - 1.963243, kTiny);
  EXPECT_NEAR(mean->interval->high, 3 + 1.963243, kTiny);
  // t(4, 0.95) = 2.131847: half = 1.507443.
  EXPECT_NEAR(meanOf(std::vector<double>{1, 2, 3, 4, 5}, 0.9)->interval->high, 3 + 1.507443, kTiny);
  const auto one = meanOf(std::vector<double>{7});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->value, 7);
  EXPECT_FALSE(one->interval);
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

TEST(Statistics, MovingMeansStartAnewAfterWhatIsMissing) {
  const std::vector<std::optional<double>> values{1, 2, 3, std::nullopt, 5, 6};
  EXPECT_THAT(movingMean(values, 2), testing::ElementsAre(std::nullopt, 1.5, 2.5, std::nullopt, std::nullopt, 5.5));
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
    EXPECT_FALSE(meanOf(values));
    EXPECT_FALSE(standardDeviation(values));
    EXPECT_FALSE(quantile(values, 0.5));
    EXPECT_FALSE(boxPlotOf(values));
    EXPECT_FALSE(percentileRank(values, 1));
  }
  EXPECT_FALSE(standardDeviation(std::vector<double>{1}));
  EXPECT_FALSE(quantile(std::vector<double>{1, 2}, 1.1));
  EXPECT_FALSE(quantile(std::vector<double>{1, 2}, kNaN));
  EXPECT_FALSE(meanOf(std::vector<double>{1, 2}, 1.0));
  EXPECT_FALSE(meanOf(std::vector<double>{1e308, 1e308, 1e308}));
  EXPECT_FALSE(proportion(0, 0));
  EXPECT_FALSE(proportion(3, 2));
  EXPECT_FALSE(proportion(-1, 2));
}

}  // namespace
}  // namespace insonate
