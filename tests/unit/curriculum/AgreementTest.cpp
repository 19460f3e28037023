#include <insonate/curriculum/Agreement.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace insonate {
namespace {

using Grades = std::vector<int>;
using Ratings = std::vector<std::vector<double>>;

/// Table 2 of Shrout and Fleiss 1979: six subjects, four judges.
const Ratings kShroutAndFleiss{{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};

TEST(Agreement, IsTheShareOfPairsThatAreAlike) {
  EXPECT_EQ(agreement(Grades{1, 2, 3, 4}, Grades{1, 2, 3, 5}), 0.75);
  EXPECT_FALSE(agreement(Grades{}, Grades{}));
  EXPECT_FALSE(agreement(Grades{1}, Grades{1, 2}));
}

TEST(Agreement, KappaOfATableOfTwoByTwo) {
  // 20 yes-yes, 5 yes-no, 10 no-yes, 15 no-no: po = 35 / 50, pe = (25 * 30 + 25 * 20) / 2500 = 0.5, kappa = 0.4.
  Grades first, second;
  const auto add = [&](int count, int a, int b) {
    first.insert(first.end(), static_cast<std::size_t>(count), a);
    second.insert(second.end(), static_cast<std::size_t>(count), b);
  };
  add(20, 1, 1), add(5, 1, 0), add(10, 0, 1), add(15, 0, 0);
  EXPECT_NEAR(*cohenKappa(first, second, 2), 0.4, 1e-12);
  // With two grades, all weights are the same.
  EXPECT_NEAR(*cohenKappa(first, second, 2, KappaWeights::Quadratic), 0.4, 1e-12);
}

TEST(Agreement, KappaOfCohensOwnTable) {
  // Cohen 1960, table 2: 200 patients by two judges; po = 0.70, pe = 0.41, kappa = 0.492.
  constexpr int kTable[3][3] = {{88, 14, 18}, {10, 40, 10}, {2, 6, 12}};
  Grades first, second;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      first.insert(first.end(), static_cast<std::size_t>(kTable[a][b]), a);
      second.insert(second.end(), static_cast<std::size_t>(kTable[a][b]), b);
    }
  EXPECT_NEAR(*agreement(first, second), 0.70, 1e-12);
  EXPECT_NEAR(*cohenKappa(first, second, 3), 0.492, 0.0005);
}

TEST(Agreement, WeightedKappaByHand) {
  // Shares of grades 0, 1, 2: 1/4, 1/4, 1/2 and 1/4, 1/2, 1/4; one pair of four differs, by one grade.
  const Grades first{0, 1, 2, 2}, second{0, 1, 1, 2};
  // Expected differences: plain 1 - (1 + 2 + 2) / 16 = 11/16, linear 14/16, quadratic 20/16.
  EXPECT_NEAR(*cohenKappa(first, second, 3), 1 - 4 / 11.0, 1e-12);
  EXPECT_NEAR(*cohenKappa(first, second, 3, KappaWeights::Linear), 1 - 4 / 14.0, 1e-12);
  EXPECT_NEAR(*cohenKappa(first, second, 3, KappaWeights::Quadratic), 0.8, 1e-12);
}

TEST(Agreement, KappaIsOneZeroOrMissing) {
  EXPECT_EQ(cohenKappa(Grades{0, 1, 2}, Grades{0, 1, 2}, 3), 1);
  EXPECT_NEAR(*cohenKappa(Grades{0, 0, 1, 1}, Grades{0, 1, 0, 1}, 2), 0, 1e-12);
  EXPECT_FALSE(cohenKappa(Grades{1, 1}, Grades{1, 1}, 2));
  EXPECT_FALSE(cohenKappa(Grades{1, 2}, Grades{1, 2}, 2));
  EXPECT_FALSE(cohenKappa(Grades{-1}, Grades{0}, 2));
  EXPECT_FALSE(cohenKappa(Grades{0}, Grades{0}, 2'000'000'000));
}

TEST(Agreement, IntraclassCorrelationOfThePublishedTable) {
  // Mean squares 11.24 (subjects), 32.49 (judges), 1.02 (rest): (11.24 - 1.02) / (11.24 + 3.06 + 4 * 31.47 / 6) = 0.29.
  const auto icc = intraclassCorrelation(kShroutAndFleiss);
  ASSERT_TRUE(icc && icc->interval);
  EXPECT_NEAR(icc->value, 0.29, 0.005);
  // 0.02 to 0.76, as the package psych of R gives it for this table.
  EXPECT_NEAR(icc->interval->low, 0.019, 0.0015);
  EXPECT_NEAR(icc->interval->high, 0.761, 0.0015);
}

TEST(Agreement, IntraclassCorrelationOfEqualAndShiftedRaters) {
  EXPECT_EQ(intraclassCorrelation({{1, 1}, {2, 2}, {3, 3}})->value, 1);
  // One rater 1 higher: subjects 2 * 1 = 2, raters 1.5, rest 0: 2 / (2 + 2 * 1.5 / 3) = 2/3.
  EXPECT_NEAR(intraclassCorrelation({{1, 2}, {2, 3}, {3, 4}})->value, 2 / 3.0, 1e-12);
  EXPECT_FALSE(intraclassCorrelation({{1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}})->interval);
}

TEST(Agreement, AnIntervalNeedsFiveAttempts) {
  const auto four = intraclassCorrelation({{1, 2}, {4, 3}, {6, 6}, {8, 9}});
  ASSERT_TRUE(four);
  EXPECT_FALSE(four->interval);
  EXPECT_EQ(four->basis, "fewer than 5 values");
  EXPECT_TRUE(intraclassCorrelation({{1, 2}, {4, 3}, {6, 6}, {8, 9}, {3, 3}})->interval);
}

TEST(Agreement, RoundingIsNoDifferenceBetweenAttempts) {
  // Scores of a checklist, all alike: means of such numbers are not quite the numbers.
  for (std::size_t attempts = 2; attempts < 12; ++attempts)
    for (int points = 0; points <= 44; ++points) {
      const double percent = 100.0 * points / 44;
      EXPECT_FALSE(intraclassCorrelation(Ratings(attempts, {percent, percent}))) << attempts << ", " << points;
    }
  const auto shifted = intraclassCorrelation({{0.1, 0.2}, {0.2, 0.3}, {0.3, 0.4}, {0.4, 0.5}, {0.5, 0.6}});
  EXPECT_NEAR(shifted->value, 5 / 6.0, 1e-12);
  EXPECT_FALSE(shifted->interval) << "as of whole numbers";
}

TEST(Agreement, AnyRatingsGiveFiniteIntervalsAboutTheirValue) {
  std::mt19937 random(1);
  const auto below = [&](unsigned end) { return static_cast<std::size_t>(random() % end); };
  int without = 0;
  for (int run = 0; run < 5000; ++run) {
    Ratings ratings(kFewestForInterval + below(4), std::vector<double>(2 + below(2)));
    for (auto& row : ratings)
      for (double& rating : row) rating = static_cast<double>(1 + below(5));
    const auto icc = intraclassCorrelation(ratings);
    if (!icc || !icc->interval) {
      ++without;
      continue;
    }
    EXPECT_LE(icc->interval->low, icc->value + 1e-9) << testing::PrintToString(ratings);
    EXPECT_GE(icc->interval->high, icc->value - 1e-9) << testing::PrintToString(ratings);
    EXPECT_TRUE(std::isfinite(icc->interval->low) && icc->interval->high < 1 + 1e-9) << testing::PrintToString(ratings);
  }
  EXPECT_LT(without, 5000 / 2);
  // Raters who contradict each other, their attempts all alike on average: -4.67 / (4.67 - 2 / 3 * 4.5).
  const auto opposed = intraclassCorrelation({{1, 4}, {4, 1}, {2, 3}});
  EXPECT_NEAR(opposed->value, -2.8, 1e-12);
  EXPECT_FALSE(opposed->interval);
}

TEST(Agreement, WhereThereIsNothingThereIsNoValue) {
  EXPECT_FALSE(intraclassCorrelation({}));
  EXPECT_FALSE(intraclassCorrelation({{1, 2}}));
  EXPECT_FALSE(intraclassCorrelation({{1}, {2}}));
  EXPECT_FALSE(intraclassCorrelation({{1, 2}, {1}}));
  EXPECT_FALSE(intraclassCorrelation({{3, 3}, {3, 3}}));
  EXPECT_FALSE(intraclassCorrelation({{1, 2}, {1, std::numeric_limits<double>::infinity()}}));
  EXPECT_FALSE(intraclassCorrelation(kShroutAndFleiss, 1));
}

}  // namespace
}  // namespace insonate
