#include <insonate/curriculum/Agreement.h>
#include <insonate/curriculum/Comparison.h>
#include <insonate/curriculum/LcCusum.h>
#include <insonate/curriculum/LearningCurve.h>
#include <insonate/curriculum/Statistics.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

/// Figures that another program computed from the same values: tests/unit/curriculum/known_answers.py, which prints
/// them in the order of the tests here (`python3 tests/unit/curriculum/known_answers.py`, Python 3.11, mpmath 1.3).
/// Intervals of means and proportions have theirs in StatisticsTest.cpp.
namespace insonate {
namespace {

using Values = std::vector<double>;

constexpr double kTiny = 1e-9;

TEST(KnownAnswers, QuantilesDeviationAndBoxPlot) {
  const Values times_s{41, 52.5, 48, 60, 55.5, 47, 63, 58, 50.5, 44, 97};
  // statistics.quantiles(method="inclusive") and statistics.stdev()
  EXPECT_NEAR(*quantile(times_s, 0.1), 44, kTiny);
  EXPECT_NEAR(*quantile(times_s, 0.25), 47.5, kTiny);
  EXPECT_NEAR(*median(times_s), 52.5, kTiny);
  EXPECT_NEAR(*quantile(times_s, 0.75), 59, kTiny);
  EXPECT_NEAR(*quantile(times_s, 0.9), 63, kTiny);
  EXPECT_NEAR(*standardDeviation(times_s), 15.18791385519, kTiny);
  const auto box = boxPlotOf(times_s);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->lowerWhisker, 41);
  EXPECT_EQ(box->upperWhisker, 63);
  EXPECT_EQ(box->outliers, Values{97});
}

TEST(KnownAnswers, MovingMean) {
  const std::vector<std::optional<double>> values{7, std::nullopt, 4, 9, 3, std::nullopt, 8};
  const std::vector<std::optional<double>> expected{7, {}, 11 / 2.0, 20 / 3.0, 16 / 3.0, {}, 20 / 3.0};
  const auto means = movingMean(values, 4);
  ASSERT_EQ(means.size(), expected.size());
  for (std::size_t i = 0; i < means.size(); ++i) {
    ASSERT_EQ(means[i].has_value(), expected[i].has_value()) << i;
    EXPECT_NEAR(means[i].value_or(0), expected[i].value_or(0), kTiny) << i;
  }
}

struct CusumAnswers {
  LcCusum test;
  double limit, success, failure;
  int fewest;
  double falseSignals, power;  ///< within 50 attempts, with the unacceptable and the acceptable rate of failure
  Values scores;
};

TEST(KnownAnswers, LcCusum) {
  const CusumAnswers all[] = {{{0.1, 0.25},
                               3.1,
                               0.182321556794,
                               -0.9162907318742,
                               18,
                               0.08878044942472,
                               0.8316645329759,
                               {0.182321556794, 0.3646431135879, 0, 0.182321556794, 0.3646431135879, 0.5469646703819,
                                0.7292862271758, 0, 0.182321556794}},
                              {{0.1, 0.4},
                               4.07,
                               0.4054651081082,
                               -1.38629436112,
                               11,
                               0.09662114157784,
                               0.9970217559188,
                               {0.4054651081082, 0.8109302162163, 0, 0.4054651081082, 0.8109302162163, 1.216395324324,
                                1.621860432433, 0.2355660713128, 0.6410311794209}}};
  for (const CusumAnswers& one : all) {
    EXPECT_NEAR(one.test.successWeight(), one.success, kTiny);
    EXPECT_NEAR(one.test.failureWeight(), one.failure, kTiny);
    EXPECT_EQ(one.test.fewestToSignal(one.limit), one.fewest);
    const Values scores = one.test.series({true, true, false, true, true, true, true, false, true});
    ASSERT_EQ(scores.size(), one.scores.size());
    for (std::size_t i = 0; i < scores.size(); ++i) EXPECT_NEAR(scores[i], one.scores[i], kTiny) << i;
    // Simulated: within four standard errors of the exact chance.
    for (const auto& [rate, exact] :
         {std::pair{one.test.unacceptable, one.falseSignals}, {one.test.acceptable, one.power}})
      EXPECT_NEAR(signalRate(one.test, one.limit, rate), exact,
                  4 * std::sqrt(exact * (1 - exact) / CusumTrials{}.careers))
          << rate;
  }
}

TEST(KnownAnswers, MannAndWhitney) {
  const auto apart = compareRanks(Values{61, 74, 80, 66, 92, 88, 71}, Values{55, 63, 79, 48, 70, 59, 52, 60});
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->u, 49);
  EXPECT_NEAR(apart->effect, 0.75, kTiny);
  EXPECT_NEAR(apart->p, 0.01398601398601, kTiny);
  const auto tied = compareRanks(Values{3, 5, 5, 2, 4, 4}, Values{1, 2, 2, 3, 0, 3, 1});
  ASSERT_TRUE(tied && tied->exact);
  EXPECT_EQ(tied->u, 38);
  EXPECT_NEAR(tied->effect, 0.8095238095238, kTiny);
  EXPECT_NEAR(tied->p, 0.01398601398601, kTiny);
  Values first, second;
  for (int i = 0; i < 25; ++i) first.push_back(i % 7 + i % 3);
  for (int i = 0; i < 22; ++i) second.push_back(i % 5 + 2 * (i % 2) + 1);
  const auto many = compareRanks(first, second);
  ASSERT_TRUE(many);
  EXPECT_FALSE(many->exact);
  EXPECT_EQ(many->u, 262);
  EXPECT_NEAR(many->p, 0.7877702453611, kTiny);
}

TEST(KnownAnswers, CohensKappa) {
  constexpr int kTable[4][4] = {{11, 3, 1, 0}, {2, 9, 4, 1}, {0, 3, 12, 5}, {1, 0, 2, 6}};
  std::vector<int> first, second;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      first.insert(first.end(), static_cast<std::size_t>(kTable[a][b]), a);
      second.insert(second.end(), static_cast<std::size_t>(kTable[a][b]), b);
    }
  EXPECT_NEAR(*cohenKappa(first, second, 4), 0.504132231405, kTiny);
  EXPECT_NEAR(*cohenKappa(first, second, 4, KappaWeights::Linear), 0.6255400864138, kTiny);
  EXPECT_NEAR(*cohenKappa(first, second, 4, KappaWeights::Quadratic), 0.722578987927, kTiny);
}

TEST(KnownAnswers, IntraclassCorrelation) {
  // Table 2 of Shrout and Fleiss 1979.
  const auto published =
      intraclassCorrelation({{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}});
  ASSERT_TRUE(published && published->interval);
  EXPECT_NEAR(published->value, 0.2897637795276, kTiny);
  EXPECT_NEAR(published->interval->low, 0.01878651337471, kTiny);
  EXPECT_NEAR(published->interval->high, 0.761084369649, kTiny);
  const auto ratings = intraclassCorrelation(
      {{62, 70, 65}, {81, 84, 90}, {45, 60, 52}, {77, 75, 83}, {90, 96, 92}, {55, 71, 58}, {68, 66, 79}, {73, 88, 80}});
  ASSERT_TRUE(ratings && ratings->interval);
  EXPECT_NEAR(ratings->value, 0.8183612457551, kTiny);
  EXPECT_NEAR(ratings->interval->low, 0.4871733765176, kTiny);
  EXPECT_NEAR(ratings->interval->high, 0.957245324914, kTiny);
}

TEST(KnownAnswers, PowerCurve) {
  const std::vector<std::optional<double>> times_s{150, 112, 104, 88, 90, 79, 83, 74, 77, 71, 74, 68, 72, 66};
  const auto fit = fitLearningCurve(LearningCurve::Shape::Power, times_s);
  ASSERT_TRUE(fit);
  constexpr double kSearch = 1e-4;  // how sharply the rate is found
  EXPECT_NEAR(fit->plateau.value, 47.31099736407, kSearch);
  EXPECT_NEAR(fit->plateau.interval->low, 28.90424761935, 1e-3);
  EXPECT_NEAR(fit->plateau.interval->high, 65.71774710878, 1e-3);
  EXPECT_NEAR(fit->gain.value, 102.1246027625, kSearch);
  EXPECT_NEAR(fit->rate, 0.5987530450085, 1e-6);
  EXPECT_NEAR(fit->residual, 3.261601305445, 1e-6);
  EXPECT_NEAR(fit->at(5), 86.27108829127, kSearch);
  EXPECT_NEAR(fit->bandAt(5).high - fit->at(5), 2.702026085524, 1e-3);
}

}  // namespace
}  // namespace insonate
