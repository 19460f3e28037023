#include "support/TestData.h"

#include <insonate/bench/SegmentationBench.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace insonate::test {
namespace {

using testing::HasSubstr;

SegmentationBench smallSegmentationBench() {
  SegmentationBench bench;
  bench.rows = {{"textbook", "native", 10.0, "bone", 0, 0.9876, 0.21, 0.5, 0.95, {}},
                {"textbook", "arterial", 10.0, "vein 1", 4, 0.95, {}, {}, 0.9, {}},
                {"textbook", "arterial", 10.0, "vein 2", 4, 0.85, {}, {}, 0.9, {}},
                {"chest CTA", "arterial", {}, "left subclavian", 4, 0.82, 0.6, 1.5, 0.9, {{0.8712, 0.9, 0.85, 0.7}}}};
  bench.times = {{"threshold preview", 78e6, 40.26, 51, 60.5, 100.0, 2}, {"growing", 8e6, 4000, 4000, 10, 3000.0, 2}};
  bench.memory = {650, 8.25};
  bench.notes = {"A note."};
  return bench;
}

TEST(SegmentationBench, RowsHaveTheNamesThatScriptsRelyOn) {
  const nlohmann::json json = toJson(smallSegmentationBench());
  for (const char* field : {"variant", "contrast", "noise_HU", "structure", "clicks", "dice", "mean_surface_mm",
                            "p95_surface_mm", "aimed_at", "exact_lumen", "center_mm", "confidence"})
    EXPECT_TRUE(json["rows"][0].contains(field)) << field;
  EXPECT_TRUE(json["rows"][1]["mean_surface_mm"].is_null());
  EXPECT_TRUE(json["rows"][3]["noise_HU"].is_null());
  EXPECT_TRUE(json["rows"][0]["exact_lumen"].is_null());
  EXPECT_EQ(json["rows"][3]["exact_lumen"][1]["wall_mm"], 0.5);
  EXPECT_EQ(json["rows"][3]["exact_lumen"][1]["dice"], 0.9);
  EXPECT_EQ(json["times"][0]["max_ms"], 51);
  EXPECT_EQ(json["times"][0]["aimed_at_ms"], 100);
  EXPECT_EQ(json["memory"]["bytes_per_voxel"], 8.25);
}

TEST(SegmentationBench, WritesTables) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeSegmentationBench(smallSegmentationBench(), folder.path() / "bench"));
  for (const char* name : {"segmentation.json", "segmentation.csv", "segmentation-times.csv", "segmentation.md"})
    EXPECT_GT(std::filesystem::file_size(folder.path() / "bench" / name), 50U) << name;
  const std::string page = bytesOf(folder.path() / "bench" / "segmentation.md");
  EXPECT_THAT(page, HasSubstr("| textbook | native | 10 | bone | 0 | 0.988 | 0.21 | 0.50 | 0.95 | met |  |"));
  EXPECT_THAT(page, HasSubstr("| textbook | arterial | 10 | vein 2 | 4 | 0.850 |  |  | 0.90 | missed |  |"));
  EXPECT_THAT(page, HasSubstr("| left subclavian | 4 | 0.820 | 0.60 | 1.50 | 0.90 | missed | 0.0 mm 0.871; 0.5 mm "
                              "0.900; 1.0 mm 0.850; 1.5 mm 0.700 |"));
  EXPECT_THAT(page, HasSubstr("| threshold preview | 78.0 | 40.3 | 51.0 | 60.5 | 2.0 | 100 | met |"));
  EXPECT_THAT(page, HasSubstr("| growing | 8.0 | 4000.0 | 4000.0 | 10.0 | 2.0 | 3000 | missed |"));
  EXPECT_THAT(page, HasSubstr("8.2 bytes a voxel; aimed at 12 (4 times CT and labels): met"));
}

TEST(SegmentationBench, SaysHowManyOfEachKindComeUpToTheBar) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeSegmentationBench(smallSegmentationBench(), folder.path() / "bench"));
  const std::string page = bytesOf(folder.path() / "bench" / "segmentation.md");
  EXPECT_THAT(page, HasSubstr("| vein | 4 | arterial | 10 | 2 | 0.850 | 0.950 | 0.90 | 1 |")) << "both veins";
}

TEST(SegmentationBench, RefusesDataThatIsNotThere) {
  const TemporaryFolder folder;
  SegmentationBenchPlan plan;
  plan.speed = false;
  plan.chestCta = folder.path();
  EXPECT_THAT(runSegmentationBench(plan).error().message, HasSubstr("ct_cropped.nii.gz"));
}

}  // namespace
}  // namespace insonate::test
