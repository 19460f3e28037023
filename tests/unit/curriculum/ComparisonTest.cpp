#include <insonate/curriculum/Comparison.h>

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
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

// Python 3.11: itertools.combinations() over all values with their mean ranks, those counted whose rank sum lies as far
// from n (n + m + 1) / 2 as the sum that was seen.
TEST(Comparison, TiesAreCountedExactly) {
  const auto comparison = compareRanks(Values{1, 2, 2, 3}, Values{2, 3, 4, 5});
  ASSERT_TRUE(comparison);
  EXPECT_TRUE(comparison->exact);
  EXPECT_EQ(comparison->u, 2.5);
  EXPECT_NEAR(comparison->p, 14 / 70.0, 1e-12);
  EXPECT_NEAR(comparison->superiority, 2.5 / 16, 1e-12);
  EXPECT_NEAR(comparison->effect, -11 / 16.0, 1e-12);
  EXPECT_NEAR(compareRanks(Values{0, 0, 0, 1, 1}, Values{0, 1, 2, 2, 3, 4})->p, 30 / 462.0, 1e-12);
  EXPECT_NEAR(compareRanks(Values{1, 2, 2, 2}, Values{2, 2, 2, 2})->p, 1, 1e-12);
}

TEST(Comparison, LargeGroupsUseTheNormalApproximationWithTies) {
  // Ties of 23 and 18 values: variance 35 (42 - (23^3 - 23 + 18^3 - 18) / (41 * 40)) = 1086.75, z = 188.5 / 32.9659;
  // p by mpmath.ncdf().
  Values first(21, 2.0), second(20, 0.0);
  second[0] = second[1] = 2;
  const auto comparison = compareRanks(first, second);
  ASSERT_TRUE(comparison);
  EXPECT_FALSE(comparison->exact);
  EXPECT_EQ(comparison->u, 399);
  EXPECT_NEAR(comparison->p, 1.077652806646435e-8, 1e-14);
}

TEST(Comparison, FewSayNothing) {
  EXPECT_FALSE(compareRanks(Values{1}, Values{2})) << "of one against one there is no effect size";
  EXPECT_FALSE(compareRanks(Values{1, 2, 3}, Values{4, 5, 6, 7}));
  EXPECT_TRUE(compareRanks(Values{1, 2, 3, 4}, Values{5, 6, 7, 8}));
}

TEST(Comparison, GroupsAreSymmetric) {
  const auto forth = compareRanks(Values{3, 5, 8, 2, 4}, Values{1, 9, 7, 6}),
             back = compareRanks(Values{1, 9, 7, 6}, Values{3, 5, 8, 2, 4});
  EXPECT_EQ(forth->u + back->u, 20);
  EXPECT_EQ(forth->p, back->p);
  EXPECT_EQ(forth->effect, -back->effect);
}

TEST(Comparison, WhatIsAlikeDoesNotDiffer) {
  const auto comparison = compareRanks(Values{2, 2, 2, 2}, Values{2, 2, 2, 2, 2});
  EXPECT_EQ(comparison->p, 1);
  EXPECT_EQ(comparison->effect, 0);
  EXPECT_FALSE(compareRanks(Values{}, Values{1}));
  EXPECT_FALSE(compareRanks(Values{1, 2, 3, 4}, Values{1, 2, 3, std::numeric_limits<double>::quiet_NaN()}));
}

}  // namespace
}  // namespace insonate
