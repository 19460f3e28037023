#include "support/TestData.h"

#include <insonate/simulator/SegmentationBench.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace insonate::test {
namespace {

using testing::HasSubstr;

SegmentationBench small() {
  SegmentationBench bench;
  bench.rows = {{"textbook", "native", 10, "bone", 0, 0.9876, 0.21, 0.5},
                {"textbook", "arterial", 10, "vein 1", 4, 0.95, {}, {}}};
  bench.times = {{"threshold preview", 78e6, 40.26, 51}};
  bench.notes = {"A note."};
  return bench;
}

TEST(SegmentationBench, RowsHaveTheNamesThatScriptsRelyOn) {
  const nlohmann::json json = toJson(small());
  for (const char* field :
       {"variant", "contrast", "noise_HU", "structure", "clicks", "dice", "mean_surface_mm", "p95_surface_mm"})
    EXPECT_TRUE(json["rows"][0].contains(field)) << field;
  EXPECT_TRUE(json["rows"][1]["mean_surface_mm"].is_null());
  EXPECT_EQ(json["times"][0]["max_ms"], 51);
}

TEST(SegmentationBench, WritesTables) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeSegmentationBench(small(), folder.path() / "bench"));
  for (const char* name : {"segmentation.json", "segmentation.csv", "segmentation-times.csv", "segmentation.md"})
    EXPECT_GT(std::filesystem::file_size(folder.path() / "bench" / name), 50U) << name;
  const std::string page = bytesOf(folder.path() / "bench" / "segmentation.md");
  EXPECT_THAT(page, HasSubstr("| textbook | native | 10 | bone | 0 | 0.988 | 0.21 | 0.50 |"));
  EXPECT_THAT(page, HasSubstr("| textbook | arterial | 10 | vein 1 | 4 | 0.950 |  |  |"));
  EXPECT_THAT(page, HasSubstr("| threshold preview | 78.0 | 40.3 | 51.0 |"));
}

}  // namespace
}  // namespace insonate::test
