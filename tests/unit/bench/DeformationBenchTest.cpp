#include "support/TestData.h"

#include <insonate/bench/DeformationBench.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <sstream>

namespace insonate::test {
namespace {

using testing::HasSubstr;
using testing::Not;

DeformationBench twoRows() {
  DeformationBench bench;
  bench.rows = {
      {.model = "elastic", .mesh_mm = 0.5, .unknowns = 15000, .state = "moving", .frames = 30, .median_ms = 8},
      {.model = "column", .mesh_mm = 0.5, .unknowns = 70000, .state = "untouched", .frames = 9, .median_ms = 1}};
  bench.rows[0].displacementRms_mm = 0.04;
  bench.rows[1].displacementRms_mm = std::numeric_limits<double>::quiet_NaN();
  bench.curves = {{4, {{0, 0, 1, 1}, {2, 10, 0.18, 0.93}}}};
  bench.notes = {"A note."};
  return bench;
}

TEST(DeformationBench, NamesItsFieldsAndLeavesOutWhatIsNoNumber) {
  const nlohmann::json json = toJson(twoRows());
  for (const char* field : {"model", "mesh_mm", "unknowns", "threads", "state", "median_ms", "p95_ms",
                            "displacement_rms_mm", "displacement_max_mm", "force_error_percent", "lumen_area_error"})
    EXPECT_TRUE(json["rows"][0].contains(field)) << field;
  EXPECT_EQ(json["rows"][0]["displacement_rms_mm"], 0.04);
  EXPECT_TRUE(json["rows"][1]["displacement_rms_mm"].is_null());
  EXPECT_EQ(json["curves"][0]["points"][1]["vein_area"], 0.18);
}

TEST(DeformationBench, WritesTablesAndPlots) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeDeformationBench(twoRows(), folder.path() / "bench"));
  for (const char* name : {"deformation.json", "deformation.csv", "compression.csv", "deformation-time.svg",
                           "compression.svg", "deformation.md"})
    EXPECT_GT(std::filesystem::file_size(folder.path() / "bench" / name), 50u) << name;
  std::ifstream page(folder.path() / "bench" / "deformation.md");
  std::stringstream text;
  text << page.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("| elastic | 0.50 | 15000 | 1 | moving |"));
  EXPECT_THAT(text.str(), HasSubstr("- A note."));
}

TEST(DeformationBench, PlotsOneThreadAndListsAllCores) {
  DeformationBench bench = twoRows();
  bench.rows.push_back(bench.rows[0]);
  bench.rows.back().threads = 2;
  bench.rows.back().mesh_mm = 0.61;
  const TemporaryFolder folder;
  ASSERT_TRUE(writeDeformationBench(bench, folder.path() / "bench"));
  const auto textOf = [&](const char* name) { return bytesOf(folder.path() / "bench" / name); };
  EXPECT_THAT(textOf("deformation.md"), HasSubstr("| elastic | 0.61 | 15000 | 2 | moving |"));
  EXPECT_THAT(textOf("deformation-time.svg"), Not(HasSubstr("0.61 mm")));
  EXPECT_THAT(textOf("deformation-time.svg"), HasSubstr("0.50 mm"));
}

}  // namespace
}  // namespace insonate::test
