#include "support/PresetFile.h"

#include <insonate/tissue/MechanicalTable.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace insonate {
namespace {

using nlohmann::json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

MechanicalTable mechanicsPreset(const std::string& name) {
  auto table = loadMechanicalTable(name);
  EXPECT_TRUE(table) << table.error().message;
  return table.value_or(MechanicalTable{});
}

TEST(MechanicalTablePresets, MeasuredComesFirst) {
  EXPECT_THAT(mechanicalPresetNames(), testing::ElementsAre("measured", "thesis"));
}

class EveryMechanicalPreset : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Presets, EveryMechanicalPreset, testing::ValuesIn(mechanicalPresetNames()),
                         [](const auto& test) { return test.param; });

TEST_P(EveryMechanicalPreset, SaysValueRangeAndSourceOfEveryNumber) {
  const json file = test::presetFile("mechanics", GetParam());
  test::SourceCheck sources(file);
  for (const json& tissue : file.at("tissues"))
    for (const auto& [key, number] : tissue.items())
      if (key != "label" && key != "kind") sources.number(number, tissue.at("label").get<std::string>() + "/" + key);
  sources.finish(26);
}

TEST_P(EveryMechanicalPreset, ListsEachLabelOnceByItsName) {
  EXPECT_EQ(test::labelsListed(test::presetFile("mechanics", GetParam())).size(), std::size_t{kLabelCount});
}

TEST(MechanicalTablePresets, ThesisIsTableOne) {
  const MechanicalTable thesis = mechanicsPreset("thesis");
  const double young_kPa[kLabelCount] = {kInfinity, 80, 200, 80, 1000, 80, 23, 80, 800, 80, 100, 80, 14000, 80, 80, 80};
  for (int label = 0; label < kLabelCount; ++label) {
    const MechanicalTissue& tissue = thesis.tissues[label];
    EXPECT_EQ(tissue.kind, Mechanics::Solid) << label;
    EXPECT_EQ(tissue.young_kPa, young_kPa[label]) << label;
    EXPECT_EQ(tissue.poisson, 0.49) << label;
  }
  EXPECT_EQ(thesis.name, "thesis");
}

TEST(MechanicalTablePresets, MeasuredHasBoneRigidVesselsHollowAndAirEmpty) {
  const MechanicalTable measured = mechanicsPreset("measured");
  for (const LabelInfo& info : labelTable()) {
    const Mechanics expected = info.label == kBone                                  ? Mechanics::Rigid
                               : info.label == kArtery || info.label == kVein       ? Mechanics::Lumen
                               : info.label == kBackground || info.label == kAirway ? Mechanics::Gas
                                                                                    : Mechanics::Solid;
    EXPECT_EQ(measured.of(info.label).kind, expected) << info.name;
  }
}

TEST(MechanicalTablePresets, MeasuredKeepsThePhysicalOrder) {
  const MechanicalTable measured = mechanicsPreset("measured");
  const auto young = [&](Label label) { return measured.of(label).young_kPa; };
  EXPECT_LT(young(kFat), young(kSoftTissue));
  EXPECT_NEAR(young(kThyroid), 11, 3);
  EXPECT_NEAR(young(kSoftTissue), 10, 3);
  EXPECT_LT(young(kMuscle), young(kSternocleidomastoid));
  EXPECT_LT(young(kSternocleidomastoid), young(kSkin));
  EXPECT_LT(young(kSkin), young(kCartilage) / 10);
  const MechanicalTissue &artery = measured.of(kArtery), &vein = measured.of(kVein);
  EXPECT_LT(vein.wall_mm, artery.wall_mm);
  EXPECT_LT(vein.wallYoung_kPa, artery.wallYoung_kPa);
  EXPECT_LT(vein.sheathYoung_kPa, young(kSoftTissue));
  EXPECT_NEAR(artery.pressure_kPa / 0.133322, 93, 0.5);
  EXPECT_NEAR(vein.pressure_kPa / 0.133322, 4, 0.05);
}

TEST(MechanicalTablePresets, UnknownLabelsReadAsSoftTissue) {
  const MechanicalTable table = mechanicsPreset("measured");
  EXPECT_EQ(&table.of(200), &table.of(kSoftTissue));
}

}  // namespace
}  // namespace insonate
