#include <insonate/teaching/MetricCatalog.h>
#include <insonate/teaching/MetricComparison.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

/// People p0, p1 ... with these points, which are the first metric.
HeatMap classOf(std::initializer_list<std::optional<double>> points, const std::string& prefix = "p") {
  HeatMap heat;
  for (const auto& one : points) {
    auto& row = heat[prefix + std::to_string(heat.size())];
    row.resize(MetricCatalog::instance().all().size());
    row[0] = {one, one, one ? 10 : 0};
  }
  return heat;
}

TEST(MetricComparison, TwoClassesHaveMeansAndRanks) {
  const MetricComparison compared =
      compareInMetric(classOf({10, 20, std::nullopt, 30, 40}), classOf({50, 60, 70, 80, 90}, "q"), 0);
  EXPECT_THAT(compared.first, ::testing::ElementsAre(10, 20, 30, 40)) << "a person without values is no value";
  EXPECT_EQ(compared.meanOfFirst->value, 25);
  EXPECT_EQ(compared.meanOfSecond->value, 70);
  EXPECT_FALSE(compared.meanOfFirst->interval) << "four values";
  EXPECT_TRUE(compared.meanOfSecond->interval);
  ASSERT_TRUE(compared.ranks);
  EXPECT_EQ(compared.ranks->effect, -1);
  EXPECT_NEAR(compared.ranks->p, 2.0 / 126, 1e-12) << "two of the C(9, 4) arrangements are as far apart";
  EXPECT_EQ(compared.inBoth, 0);
}

TEST(MetricComparison, AClassWithThreeValuesIsNotCompared) {
  const MetricComparison compared = compareInMetric(classOf({1, 2, 3}), classOf({1, 2, 3, 4}), 0);
  EXPECT_FALSE(compared.ranks);
  EXPECT_EQ(compared.inBoth, 3);
  EXPECT_FALSE(compareInMetric({}, classOf({1}), 0).meanOfFirst);
}

TEST(MetricComparison, ThePlaceInTheClassCountsEqualValuesApart) {
  const std::vector<double> all{1, 2, 2, 2, 5};
  MetricMeaning meaning;
  meaning.better = MetricMeaning::Better::Higher;
  const PlaceInClass high = placeAmong(all, 2, meaning);
  EXPECT_EQ(high.others, 4);
  EXPECT_EQ(high.worse, 1);
  EXPECT_EQ(high.equal, 2);
  meaning.better = MetricMeaning::Better::Lower;
  EXPECT_EQ(placeAmong(all, 1, meaning).worse, 4);
}

}  // namespace
}  // namespace insonate
