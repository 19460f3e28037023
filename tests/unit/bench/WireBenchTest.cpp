#include "support/TestData.h"

#include <insonate/bench/WireBench.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace insonate::test {
namespace {

TEST(WireBench, QuickRunAgreesWithTheConvergedWire) {
  const auto bench = runWireBench(true);
  ASSERT_TRUE(bench) << bench.error().message;
  ASSERT_EQ(bench->rows.size(), 3U);
  for (const WireBenchRow& row : bench->rows) {
    EXPECT_EQ(row.wire, "j-tip");
    EXPECT_NEAR(row.inserted_mm, 60, 1e-6) << row.spacing_mm;
    EXPECT_GT(row.median_ms, 0);
    EXPECT_LT(row.unbalanced_N, 1e-3) << row.spacing_mm;
  }
  EXPECT_LT(bench->rows[1].error_mm, 0.5) << "the spacing of training";
}

TEST(WireBench, WritesTables) {
  const TemporaryFolder folder;
  WireBench bench;
  bench.rows = {{.wire = "j-tip", .spacing_mm = 2, .angle_deg = 40, .median_ms = 0.25}};
  bench.notes = {"A note."};
  ASSERT_TRUE(writeWireBench(bench, folder.path() / "bench"));
  std::ifstream page(folder.path() / "bench" / "wire.md");
  std::stringstream text;
  text << page.rdbuf();
  EXPECT_THAT(text.str(), testing::HasSubstr("| j-tip | 40 | 2.00 | 0 | 0.250 |"));
  EXPECT_THAT(text.str(), testing::HasSubstr("- A note."));
  EXPECT_EQ(toJson(bench)["rows"][0]["wire"], "j-tip");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "bench" / "wire.csv"));
}

}  // namespace
}  // namespace insonate::test
