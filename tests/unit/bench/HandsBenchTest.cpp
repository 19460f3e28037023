#include "support/TestData.h"

#include <insonate/bench/HandsBench.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace insonate::test {
namespace {

TEST(HandsBench, QuickRunMeetsTheAimsAndWritesItsTables) {
  const auto bench = runHandsBench(true);
  ASSERT_TRUE(bench) << bench.error().message;
  ASSERT_EQ(bench->rows.size(), 2U);
  for (const HandsBenchRow& row : bench->rows) {
    EXPECT_EQ(row.intensities.seen, 1) << row.condition;
    EXPECT_LT(row.intensities.tip_mm, 0.8) << row.condition;
    EXPECT_LT(row.intensities.direction_deg, 0.3) << row.condition;
    EXPECT_LT(row.intensities.tip_mm, row.corners.tip_mm) << row.condition;
  }
  EXPECT_LT(bench->rows.front().jitter_mm, 0.15);
  const TemporaryFolder folder;
  ASSERT_TRUE(writeHandsBench(*bench, folder / "out"));
  EXPECT_EQ(nlohmann::json::parse(bytesOf(folder.path() / "out" / "hands.json"))["rows"].size(), 2U);
  EXPECT_THAT(bytesOf(folder.path() / "out" / "hands.md"), testing::HasSubstr("| usual motion |"));
}

TEST(HandsBench, StopsWhenCancelled) {
  EXPECT_FALSE(runHandsBench(true, [](std::string_view, double) { return false; }));
}

}  // namespace
}  // namespace insonate::test
