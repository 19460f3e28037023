#include <insonate/core/Hash.h>

#include <gtest/gtest.h>

#include <bit>

namespace insonate {
namespace {

TEST(Hash, IsTheSameOnEveryMachine) {
  // Phantoms and recordings depend on these values; they were computed apart from this code.
  static_assert(hash32(0) == 0);
  EXPECT_EQ(hash32(1), 2261973619U);
  EXPECT_EQ(hashNode(1, -2, 3, 7), 3819171999U);
}

TEST(Hash, OneBitIntoAboutHalfTheBitsOut) {
  double flipped = 0;
  int trials = 0;
  for (std::uint32_t x = 1; x < 2000; ++x)
    for (int bit = 0; bit < 32; ++bit, ++trials) flipped += std::popcount(hash32(x) ^ hash32(x ^ (1U << bit)));
  EXPECT_NEAR(flipped / trials, 16, 0.1);
}

TEST(Hash, NodesOfALatticeAreUniformAndUncorrelatedWithTheirNeighbors) {
  double sum = 0, squares = 0, neighbors = 0;
  constexpr int n = 40;
  const auto value = [](int i, int j, int k) { return unitInterval(hashNode(i, j, k, 1)) - 0.5; };
  for (int k = -n / 2; k < n / 2; ++k)
    for (int j = -n / 2; j < n / 2; ++j)
      for (int i = -n / 2; i < n / 2; ++i) {
        const double v = value(i, j, k);
        sum += v;
        squares += v * v;
        neighbors += v * (value(i + 1, j, k) + value(i, j + 1, k) + value(i, j, k + 1));
      }
  constexpr double count = n * n * n;
  EXPECT_NEAR(sum / count, 0, 0.005);
  EXPECT_NEAR(squares / count, 1.0 / 12, 0.002);
  EXPECT_NEAR(neighbors / squares, 0, 0.03);
}

TEST(Hash, SeedsGiveUnrelatedFields) {
  double product = 0;
  for (int i = 0; i < 20000; ++i)
    product += (unitInterval(hashNode(i, 0, 0, 1)) - 0.5) * (unitInterval(hashNode(i, 0, 0, 2)) - 0.5);
  EXPECT_NEAR(product / 20000 * 12, 0, 0.03);
}

TEST(Hash, UnitIntervalExcludesOne) {
  EXPECT_EQ(unitInterval(0), 0);
  EXPECT_LT(unitInterval(0xffffffffU), 1);
}

}  // namespace
}  // namespace insonate
