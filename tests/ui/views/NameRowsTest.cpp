#include "overlay/NameRows.h"

#include <gtest/gtest.h>

namespace insonate::views {
namespace {

TEST(NameRows, NamesOfOnePlaceStandInRowsUntilThereAreTooMany) {
  NameRows rows(800, 12);
  std::vector<DisplayPoint> at;
  for (int n = 0; n < 5; ++n) {
    const auto placed = rows.put({100, 200}, 20);
    ASSERT_TRUE(placed) << n;
    EXPECT_EQ(placed->letters, 20u);
    EXPECT_GT(placed->at.x, 100);
    EXPECT_FALSE(placed->before);
    at.push_back(placed->at);
  }
  EXPECT_EQ(at[0].y, 200);
  for (std::size_t a = 0; a < at.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_GE(std::abs(at[a].y - at[b].y), 12);
  EXPECT_FALSE(rows.put({100, 200}, 20)) << "its mark stays without a name";
  EXPECT_TRUE(rows.put({600, 200}, 20)) << "far enough aside";
}

TEST(NameRows, ANameAtTheRightEdgeStandsBeforeItsMark) {
  NameRows rows(300, 12);
  const auto placed = rows.put({280, 50}, 12);
  ASSERT_TRUE(placed);
  EXPECT_TRUE(placed->before);
  EXPECT_LT(placed->at.x, 280);
}

TEST(NameRows, ALongNameCrossesNeitherThePictureNorItsEdge) {
  constexpr double kWidth = 360, kSize = 12;
  for (const double x : {2.0, 90.0, 180.0, 300.0, 358.0}) {
    const auto placed = NameRows(kWidth, kSize).put({x, 150}, 60);
    ASSERT_TRUE(placed) << x;
    EXPECT_GE(placed->letters, 10u) << x;
    const double length = 0.6 * kSize * double(placed->letters);
    EXPECT_LT(length, kWidth / 2) << x;
    EXPECT_GE(placed->before ? placed->at.x - length : placed->at.x, -5) << x;
    EXPECT_LE(placed->before ? placed->at.x : placed->at.x + length, kWidth + 5) << x;
  }
  EXPECT_FALSE(NameRows(30, kSize).put({15, 10}, 60)) << "a mark in a sliver of a view has no name";
}

}  // namespace
}  // namespace insonate::views
