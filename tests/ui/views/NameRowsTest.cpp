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
  const auto placed = rows.put({280, 50}, 20);
  ASSERT_TRUE(placed);
  EXPECT_TRUE(placed->before);
  EXPECT_LT(placed->at.x, 280);
  EXPECT_FALSE(rows.put({280, 150}, 60)->before) << "no room on either side: its beginning is seen";
}

}  // namespace
}  // namespace insonate::views
