#include <insonate/curriculum/Comparison.h>

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace insonate {
namespace {

using Values = std::vector<double>;

TEST(Comparison, ExactChancesAreThoseOfCountingArrangements) {
  // 5 and 5 values: of 252 arrangements 1, 1 and 2 have U = 0, 1 and 2.
  EXPECT_NEAR(compareRanks(Values{1, 2, 3, 4, 5}, Values{6, 7, 8, 9, 10})->p, 2 * 1 / 252.0, 1e-12);
  EXPECT_NEAR(compareRanks(Values{1, 2, 3, 4, 6}, Values{5, 7, 8, 9, 10})->p, 2 * 2 / 252.0, 1e-12);
  EXPECT_NEAR(compareRanks(Values{1, 2, 3, 5, 6}, Values{4, 7, 8, 9, 10})->p, 2 * 4 / 252.0, 1e-12);
  // 20 and 20: the table's two-sided 5 % limit is U = 127.
  const auto chanceOf = [](int u) {
    Values first(20), second(20);
    std::iota(first.begin(), first.end(), 100.0);
    std::iota(second.begin(), second.end(), 200.0);
    // Each step of a value over one of the other group is one more pair.
    for (int i = 19; u > 0; --i) {
      const int steps = std::min(u, 20);
      first[static_cast<std::size_t>(i)] = 199.5 + steps + 0.01 * i;
      u -= steps;
    }
    return compareRanks(first, second);
  };
  EXPECT_EQ(chanceOf(127)->u, 127);
  EXPECT_TRUE(chanceOf(127)->exact);
  EXPECT_LE(chanceOf(127)->p, 0.05);
  EXPECT_GT(chanceOf(128)->p, 0.05);
}

TEST(Comparison, TiesUseTheNormalApproximation) {
  // U: two ties, half each = 1 of 12. Variance 12 / 12 (8 - (27 - 3) / 42) = 7.428571, z = (5 - 0.5) / 2.725541.
  const auto comparison = compareRanks(Values{1, 2, 2}, Values{2, 3, 4, 5});
  ASSERT_TRUE(comparison);
  EXPECT_EQ(comparison->u, 1);
  EXPECT_FALSE(comparison->exact);
  EXPECT_NEAR(comparison->p, 0.098729, 1e-5);
  EXPECT_NEAR(comparison->superiority, 1 / 12.0, 1e-12);
  EXPECT_NEAR(comparison->effect, -10 / 12.0, 1e-12);
}

TEST(Comparison, ApproximationAndCountingAgree) {
  std::mt19937 random(5);
  for (int run = 0; run < 20; ++run) {
    Values first{-2, -1}, second;
    while (first.size() < 20) first.push_back(static_cast<double>(random()));
    while (second.size() < 20) second.push_back(static_cast<double>(random()) + 5e8);
    const auto counted = compareRanks(first, second);
    first[1] = first[0];  // a tie that leaves U as it was
    const auto approximated = compareRanks(first, second);
    EXPECT_TRUE(counted->exact && !approximated->exact);
    EXPECT_EQ(approximated->u, counted->u);
    EXPECT_NEAR(approximated->p, counted->p, 0.01);
  }
}

TEST(Comparison, GroupsAreSymmetric) {
  const auto forth = compareRanks(Values{3, 5, 8}, Values{1, 9}), back = compareRanks(Values{1, 9}, Values{3, 5, 8});
  EXPECT_EQ(forth->u + back->u, 6);
  EXPECT_EQ(forth->p, back->p);
  EXPECT_EQ(forth->effect, -back->effect);
}

TEST(Comparison, WhatIsAlikeDoesNotDiffer) {
  const auto comparison = compareRanks(Values{2, 2, 2}, Values{2, 2});
  EXPECT_EQ(comparison->p, 1);
  EXPECT_EQ(comparison->effect, 0);
  EXPECT_FALSE(compareRanks(Values{}, Values{1}));
  EXPECT_FALSE(compareRanks(Values{1}, Values{std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_EQ(compareRanks(Values{1}, Values{2})->p, 1);
}

}  // namespace
}  // namespace insonate
