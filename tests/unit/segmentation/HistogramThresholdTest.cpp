#include <insonate/segmentation/HistogramThreshold.h>

#include <gtest/gtest.h>

#include <vector>

namespace insonate {
namespace {

/// The variance between the classes, by its definition.
double between(const std::vector<std::uint64_t>& counts, std::size_t bin) {
  double below = 0, above = 0, meanBelow = 0, meanAbove = 0;
  for (std::size_t b = 0; b < counts.size(); ++b) {
    const auto count = double(counts[b]);
    (b < bin ? below : above) += count;
    (b < bin ? meanBelow : meanAbove) += count * double(b);
  }
  if (below == 0 || above == 0) return 0;
  const double apart = meanBelow / below - meanAbove / above;
  return below * above * apart * apart;
}

TEST(HistogramThreshold, PartsWhereTheClassesDifferMost) {
  const std::vector<std::uint64_t> counts{5, 40, 90, 30, 6, 1, 0, 2, 9, 30, 55, 20, 3};
  const auto found = otsuBin(counts);
  ASSERT_TRUE(found);
  for (std::size_t bin = 1; bin < counts.size(); ++bin) EXPECT_GE(between(counts, *found), between(counts, bin)) << bin;
}

TEST(HistogramThreshold, OneTissueIsNotParted) {
  EXPECT_FALSE(otsuBin({}));
  EXPECT_FALSE(otsuBin(std::vector<std::uint64_t>{0, 0, 7, 0}));
  EXPECT_FALSE(otsuBin(std::vector<std::uint64_t>(8)));
}

TEST(HistogramThreshold, TwoBinsArePartedBetweenThem) {
  const auto found = otsuBin(std::vector<std::uint64_t>{0, 1000000, 0, 0, 3, 0});
  ASSERT_TRUE(found);
  EXPECT_GT(*found, 1u);
  EXPECT_LE(*found, 4u);
}

}  // namespace
}  // namespace insonate
