#include <insonate/tissue/NeedleTable.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace insonate {
namespace {

using testing::HasSubstr;

TEST(NeedleTable, MeasuredIsTheDefault) {
  EXPECT_EQ(needlePresetNames(), (std::vector<std::string>{"measured", "thesis"}));
}

/// Table II of the thesis: needle with skin, vein, artery and bone; transducer with skin only.
TEST(NeedleTable, WallsOfTheThesisAreItsTableII) {
  const auto table = loadNeedleTable("thesis");
  ASSERT_TRUE(table) << table.error().message;
  for (int label = 0; label < kLabelCount; ++label) {
    const NeedleTissue& tissue = table->tissues[label];
    const bool membrane = label == kSkin || label == kVein || label == kArtery;
    EXPECT_EQ(tissue.wall, membrane         ? NeedleWall::Membrane
                           : label == kBone ? NeedleWall::Hard
                                            : NeedleWall::None)
        << labelTable()[label].name;
    EXPECT_EQ(tissue.probeTouches, label == kSkin) << labelTable()[label].name;
  }
}

TEST(NeedleTable, MeasuredValuesAreOfPublishedMagnitude) {
  const auto table = loadNeedleTable("measured");
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_NEAR(table->of(kSkin).puncture_N, 1.8, 1.3);
  EXPECT_LT(table->of(kVein).puncture_N, table->of(kArtery).puncture_N);
  EXPECT_LT(table->of(kFat).cutting_N, table->of(kMuscle).cutting_N);
  EXPECT_NEAR(table->of(kSoftTissue).friction_Npmm, 0.011, 0.001);
  EXPECT_EQ(table->of(kAirway).wall, NeedleWall::Membrane);
  EXPECT_EQ(table->of(200), table->of(kSoftTissue));
}

TEST(NeedleTable, EveryNumberOfThePresetsHasRangeAndSource) {
  for (const std::string& name : needlePresetNames()) {
    std::ifstream stream(std::string(INSONATE_SOURCE_DIR) + "/resources/haptics/" + name + ".json");
    const auto file = nlohmann::json::parse(stream);
    for (const auto& tissue : file["tissues"])
      for (const auto& [key, value] : tissue.items()) {
        if (value.is_string()) continue;
        const std::string where = name + ": " + tissue["label"].get<std::string>() + " " + key;
        ASSERT_TRUE(value.is_object()) << where;
        EXPECT_TRUE(value.contains("range")) << where;
        EXPECT_FALSE(value.value("source", "").empty()) << where;
      }
  }
}

TEST(NeedleTable, RefusesWhatContradictsItself) {
  const auto slippery = parseNeedleTable(
      R"({"base": "measured", "tissues": [{"label": "fat", "friction_Npmm": 0.2, "stiction_Npmm": 0.1}]})");
  ASSERT_FALSE(slippery);
  EXPECT_THAT(slippery.error().message, HasSubstr("tissue 'fat' has 'stiction_Npmm' below 'friction_Npmm'"));
  const auto open = parseNeedleTable(R"({"base": "measured", "tissues": [{"label": "vein", "puncture_N": 0}]})");
  ASSERT_FALSE(open);
  EXPECT_THAT(open.error().message, HasSubstr("tissue 'vein' has a membrane, which needs 'puncture_N' above 0."));
  const auto wall = parseNeedleTable(R"({"base": "measured", "tissues": [{"label": "vein", "wall": "soft"}]})");
  ASSERT_FALSE(wall);
  EXPECT_THAT(wall.error().message, HasSubstr("has the unknown wall 'soft'; it is one of none, membrane, hard."));
}

}  // namespace
}  // namespace insonate
