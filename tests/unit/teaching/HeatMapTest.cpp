#include <insonate/curriculum/Curriculum.h>
#include <insonate/teaching/HeatMap.h>
#include <insonate/teaching/MetricCatalog.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

constexpr const char* kProcedure = "internal_jugular";

std::size_t columnOf(const std::string& metric) {
  const auto& all = MetricCatalog::instance().all();
  return std::size_t(std::ranges::find(all, metric, &MetricMeaning::id) - all.begin());
}

const MetricMeaning& meaningOf(const std::string& metric) {
  return MetricCatalog::instance().withNormsOf(kProcedure, MetricCatalog::instance().all()[columnOf(metric)]);
}

/// The cell of a person with one attempt for each value.
HeatCell cellOf(const std::string& metric, const std::vector<double>& values) {
  std::vector<AttemptFacts> attempts;
  for (const double value : values) {
    AttemptFacts facts;
    facts.person = "anna", facts.procedure = kProcedure, facts.state = AttemptState::Completed;
    facts.metrics = {{"passes", 1, 1.0}, {metric, meaningOf(metric).version, value}};
    attempts.push_back(std::move(facts));
  }
  const HeatMap map = heatMapOf(attempts);
  return map.at("anna")[columnOf(metric)];
}

std::vector<double> counts(int ones, int zeros) {
  std::vector<double> values(std::size_t(ones), 1.0);
  values.insert(values.end(), std::size_t(zeros), 0.0);
  return values;
}

TEST(HeatMapTest, TheColorOfACountIsThatOfItsRateBetweenTheNorms) {
  const MetricMeaning& artery = meaningOf("artery_punctures");
  ASSERT_EQ(artery.novice, 0.21);
  ASSERT_EQ(artery.expert, 0.02);
  EXPECT_EQ(cellOf("artery_punctures", counts(3, 7)).share, 0) << "0.30: worse than a novice";
  EXPECT_NEAR(*cellOf("artery_punctures", counts(2, 8)).share, 100 * 0.01 / 0.19, 1e-9) << "0.20";
  EXPECT_NEAR(*cellOf("artery_punctures", counts(1, 9)).share, 100 * 0.11 / 0.19, 1e-9) << "0.10";
  EXPECT_EQ(cellOf("artery_punctures", counts(0, 10)).share, 100);
  ASSERT_EQ(meaningOf("double_punctures").novice, 0.49);
  EXPECT_EQ(cellOf("double_punctures", counts(5, 5)).share, 0);
  EXPECT_NEAR(*cellOf("double_punctures", counts(4, 6)).share, 25, 1e-9);
}

TEST(HeatMapTest, TheColorOfAMeanIsThatOfTheResult) {
  const MetricMeaning& path = meaningOf("needle_path_mm");
  for (const std::vector<double>& values : {std::vector{58.0, 41.0}, {20.0, 60.0}, {10.0, 10.0}, {90.0}}) {
    const HeatCell cell = cellOf("needle_path_mm", values);
    EXPECT_NEAR(*cell.share, *path.positionBetweenNorms(*cell.value), 1e-9) << *cell.value;
  }
}

TEST(HeatMapTest, MetricsWithoutNormsHaveNoColor) {
  EXPECT_FALSE(cellOf("bone_contacts", {1}).share);
  EXPECT_EQ(cellOf("bone_contacts", {1}).value, 1);
}

}  // namespace
}  // namespace insonate
