#include "support/TestData.h"

#include <insonate/bench/HapticsBench.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace insonate::test {
namespace {

using testing::HasSubstr;

HapticsBench smallHapticsBench() {
  HapticsBench bench;
  bench.rows = {{.scenario = "idle", .ticks = 2000, .lateTicks = 3, .p50_us = 2.5, .p99_us = 9, .p999_us = 20}};
  bench.stiffness = {{"Touch", 0.4, 5.2, 13, 19}};
  bench.colgate = {"free", 0, 0.4, 0.41, 0.5};
  bench.curves = {{"measured", std::vector<ForceDepthPoint>(100, {1, 0.5, kSkin})}};
  bench.notes = {"A note."};
  return bench;
}

TEST(HapticsBench, RowsHaveTheNamesThatScriptsRelyOn) {
  const nlohmann::json json = toJson(smallHapticsBench());
  for (const char* field :
       {"scenario", "ticks", "p50_us", "p99_us", "p999_us", "max_us", "late_ticks", "passivity_min_J"})
    EXPECT_TRUE(json["rows"][0].contains(field)) << field;
  EXPECT_EQ(json["rows"][0]["late_ticks"], 3);
  EXPECT_EQ(json["stiffness"][0]["device"], "free");
  EXPECT_EQ(json["stiffness"][1]["bound_Npmm"], 5.2);
}

TEST(HapticsBench, WritesTablesAndPlots) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeHapticsBench(smallHapticsBench(), folder.path() / "bench"));
  for (const char* name :
       {"haptics.json", "haptics.csv", "stiffness.csv", "force-depth.csv", "force-depth.svg", "haptics.md"})
    EXPECT_GT(std::filesystem::file_size(folder.path() / "bench" / name), 50U) << name;
  std::ifstream page(folder.path() / "bench" / "haptics.md");
  std::stringstream text;
  text << page.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("| idle | 2000 | 2.50 | 9.00 | 20.00 |"));
  EXPECT_THAT(text.str(), HasSubstr("| Touch | 0.40 | 5.20 | 13.00 | 19.00 |"));
  EXPECT_THAT(text.str(), HasSubstr("- A note."));
}

}  // namespace
}  // namespace insonate::test
