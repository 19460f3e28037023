#include "support/TestData.h"

#include <insonate/bench/SegmentationBench.h>

#include <map>

namespace insonate::test {
namespace {

std::map<std::string, SegmentationScoreRow> byStructure(const SegmentationBench& bench, int clicks) {
  std::map<std::string, SegmentationScoreRow> rows;
  for (const SegmentationScoreRow& row : bench.rows)
    if (row.clicks == clicks) rows[row.structure] = row;
  return rows;
}

// The masks are of voxels of 1.5 mm and hold walls: a lumen found exactly scores 0.83 to 0.94, and 0.90 is aimed at.
TEST(SegmentationScores, BranchesOfTheAortaOnAChestCta) {
  INSONATE_NEEDS_DATA("chest-cta");
  SegmentationBenchPlan plan;
  plan.speed = false;
  plan.chestCta = testData("chest-cta");
  const auto bench = runSegmentationBench(plan);
  ASSERT_TRUE(bench) << bench.error().message;
  const auto rows = byStructure(*bench, 4);
  for (const char* name : {"left common carotid", "left subclavian", "brachiocephalic trunk"}) {
    ASSERT_TRUE(rows.contains(name)) << name;
    EXPECT_GT(rows.at(name).dice, 0.8) << name;
    EXPECT_LT(rows.at(name).meanSurface_mm, 1.5) << name << ": a voxel";
    ASSERT_TRUE(rows.at(name).exactLumen) << name;
    EXPECT_GT(rows.at(name).exactLumen->front(), 0.8) << name;
    EXPECT_LT(rows.at(name).exactLumen->back(), rows.at(name).exactLumen->front()) << name << ": 1.5 mm more";
  }
  for (const char* name : {"left common carotid", "left subclavian"})
    EXPECT_GT(rows.at(name).dice, rows.at(name).exactLumen->front() - 0.02) << name;
}

TEST(SegmentationScores, TheAtlasWithASyntheticCt) {
  INSONATE_NEEDS_DATA("neck-atlas-labels");
  SegmentationBenchPlan plan;
  plan.speed = false, plan.quick = true;
  plan.atlas = testData("neck-atlas-labels/HN-Atlas-labels.nrrd");
  plan.atlasMap = std::filesystem::path(INSONATE_SOURCE_DIR) / "resources/maps/spl-head-neck.json";
  const auto bench = runSegmentationBench(plan);
  ASSERT_TRUE(bench) << bench.error().message;
  const auto found = byStructure(*bench, 0), clicked = byStructure(*bench, 4);
  for (const char* name : {"bone", "airway and lung"}) {
    ASSERT_TRUE(found.contains(name)) << name;
    EXPECT_GT(found.at(name).dice, 0.95) << name;
  }
  EXPECT_GT(found.at("skin").dice, 0.84) << "two voxels thick";
  for (const char* name : {"vein 1", "vein 2", "artery 1", "artery 2"}) {
    ASSERT_TRUE(clicked.contains(name)) << name;
    EXPECT_GT(clicked.at(name).dice, 0.9) << name;
  }
}

}  // namespace
}  // namespace insonate::test
