#include "support/PresetFile.h"

#include <insonate/tissue/AcousticTable.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace insonate {
namespace {

using nlohmann::json;

AcousticTable preset(const std::string& name) {
  auto table = loadAcousticTable(name);
  EXPECT_TRUE(table) << table.error().message;
  return table.value_or(AcousticTable{});
}

/// Calls `visit` with every number of a preset and where it is.
template <class Visit>
void visitNumbers(const json& node, const std::string& where, const Visit& visit) {
  if (node.is_number()) return visit(node, where);
  if (node.is_object() && node.contains("value")) return visit(node, where);
  if (!node.is_structured()) return;
  for (const auto& [key, child] : node.items()) visitNumbers(child, where + "/" + key, visit);
}

TEST(AcousticTablePresets, NeckComesFirst) {
  EXPECT_THAT(acousticPresetNames(), testing::ElementsAre("neck", "thesis"));
}

class EveryPreset : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Presets, EveryPreset, testing::ValuesIn(acousticPresetNames()),
                         [](const auto& test) { return test.param; });

TEST_P(EveryPreset, SaysValueRangeAndSourceOfEveryNumber) {
  const json file = test::presetFile("tissues", GetParam());
  test::SourceCheck sources(file);
  visitNumbers(file.at("tissues"), "",
               [&](const json& number, const std::string& where) { sources.number(number, where); });
  sources.finish(11);
}

TEST_P(EveryPreset, ListsEachLabelAtMostOnceByItsName) {
  EXPECT_FALSE(test::labelsListed(test::presetFile("tissues", GetParam())).empty());
}

TEST_P(EveryPreset, KeepsThePhysicalOrderOfTissues) {
  const AcousticTable table = preset(GetParam());
  const auto impedance = [&](Label label) { return table.of(label).impedance_MRayl; };
  EXPECT_LT(impedance(kAirway), 0.001);
  EXPECT_LT(impedance(kFat), impedance(kSoftTissue));
  EXPECT_LT(impedance(kSoftTissue), impedance(kMuscle));
  EXPECT_LT(impedance(kMuscle), impedance(kCartilage));
  EXPECT_LT(impedance(kCartilage), impedance(kBone));
  EXPECT_EQ(impedance(kArtery), impedance(kVein));
  const auto attenuation = [&](Label label) { return table.of(label).attenuation_dBpcmMHz; };
  for (const Label label : {kSkin, kFat, kMuscle, kThyroid, kSoftTissue, kGland})
    EXPECT_LT(attenuation(kVein), attenuation(label)) << int{label};
  const auto echo = [&](Label label) { return table.of(label).echogenicity_dB; };
  EXPECT_LT(echo(kVein), echo(kMuscle));
  EXPECT_LT(echo(kMuscle), echo(kThyroid));
}

TEST_P(EveryPreset, MarksVesselsAndGas) {
  const AcousticTable table = preset(GetParam());
  for (const LabelInfo& info : labelTable()) {
    EXPECT_EQ(table.of(info.label).vessel, info.label == kArtery || info.label == kVein) << info.name;
    EXPECT_EQ(table.of(info.label).gas, info.label == kAirway || info.label == kBackground) << info.name;
  }
}

TEST(AcousticTablePresets, BloodAirAndBoneDoNotFollowTheCt) {
  const AcousticTable table = preset("neck");
  for (const Label label : {kBackground, kAirway, kArtery, kVein, kBone}) {
    EXPECT_EQ(table.of(label).ctImpedancePer100HU, 0) << int{label};
    EXPECT_EQ(table.of(label).ctEchogenicity_dBper100HU, 0) << int{label};
  }
  EXPECT_GT(table.of(kMuscle).ctEchogenicity_dBper100HU, 0);
}

TEST(AcousticTablePresets, ArteryHasIntimaMediaAndAdventitia) {
  const auto layers = preset("neck").of(kArtery).layers;
  ASSERT_EQ(layers.size(), 4u);
  for (std::size_t n = 1; n < layers.size(); ++n) EXPECT_LE(layers[n - 1].to_mm, layers[n].from_mm);
  EXPECT_LT(layers[1].echo_dB, layers[0].echo_dB) << "the media is the dark line between two bright ones";
  EXPECT_GT(layers[2].echo_dB, layers[3].echo_dB) << "its outer border is a line, the adventitia a band";
  const double thickness_mm = layers[2].from_mm;
  EXPECT_GT(thickness_mm, 0.45);
  EXPECT_LT(thickness_mm, 0.8) << "thickness of intima and media of adults";
}

TEST(AcousticTablePresets, ThesisIsNeckWithoutLayersAndTexture) {
  const AcousticTable neck = preset("neck"), thesis = preset("thesis");
  for (const LabelInfo& info : labelTable()) {
    EXPECT_TRUE(thesis.of(info.label).layers.empty()) << info.name;
    EXPECT_EQ(thesis.of(info.label).texture, Texture::None) << info.name;
    EXPECT_EQ(thesis.of(info.label).impedance_MRayl, neck.of(info.label).impedance_MRayl) << info.name;
    EXPECT_EQ(thesis.of(info.label).attenuation_dBpcmMHz, neck.of(info.label).attenuation_dBpcmMHz) << info.name;
  }
}

TEST(AcousticTablePresets, UnknownLabelsReadAsSoftTissue) {
  const AcousticTable table = preset("neck");
  EXPECT_EQ(&table.of(200), &table.of(kSoftTissue));
}

}  // namespace
}  // namespace insonate
