#include "support/TestData.h"

#include <insonate/tissue/AcousticTable.h>

#include <gmock/gmock.h>

#include <fstream>

namespace insonate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

AcousticTable parsed(const std::string& text) {
  auto table = parseAcousticTable(text);
  EXPECT_TRUE(table) << table.error().message;
  return table.value_or(AcousticTable{});
}

std::string refusalOf(const std::string& text) {
  const auto table = parseAcousticTable(text);
  EXPECT_FALSE(table) << text;
  return table ? "" : table.error().message;
}

std::string overriding(const std::string& fields, const std::string& label = "\"fat\"") {
  return R"({"base": "neck", "tissues": [{"label": )" + label + ", " + fields + "}]}";
}

TEST(AcousticTableOverrides, ReplaceOnlyWhatTheyName) {
  const AcousticTable neck = *loadAcousticTable("neck");
  const AcousticTable table = parsed(overriding(R"("attenuation_dBpcmMHz": 0.9, "texture": "none")"));
  EXPECT_EQ(table.of(kFat).attenuation_dBpcmMHz, 0.9);
  EXPECT_EQ(table.of(kFat).texture, Texture::None);
  EXPECT_EQ(table.of(kFat).impedance_MRayl, neck.of(kFat).impedance_MRayl);
  EXPECT_EQ(table.of(kMuscle).attenuation_dBpcmMHz, neck.of(kMuscle).attenuation_dBpcmMHz);
  EXPECT_EQ(table.of(kMuscle).layers.size(), neck.of(kMuscle).layers.size());
}

TEST(AcousticTableOverrides, TakeALabelsNumberAndAnAnnotatedValue) {
  const AcousticTable table = parsed(overriding(
      R"("echogenicity_dB": {"value": 3, "range": [0, 6], "source": "own measurement"}, "vessel": true)", "11"));
  EXPECT_EQ(table.of(kMuscle).echogenicity_dB, 3);
  EXPECT_TRUE(table.of(kMuscle).vessel);
}

TEST(AcousticTableOverrides, ReplaceTheWholeListOfLayers) {
  const AcousticTable table = parsed(overriding(
      R"("layers": [{"from_mm": -1, "to_mm": 0.5, "echo_dB": 9, "anisotropy": 1, "patchiness": 0.5}])", "\"artery\""));
  ASSERT_EQ(table.of(kArtery).layers.size(), 1u);
  EXPECT_EQ(table.of(kArtery).layers[0].from_mm, -1);
  EXPECT_EQ(table.of(kArtery).layers[0].patchiness, 0.5);
}

TEST(AcousticTableOverrides, RefusalNamesTissueFieldValueAndRange) {
  EXPECT_THAT(refusalOf(overriding(R"("impedance_MRayl": -1)")),
              AllOf(HasSubstr("fat"), HasSubstr("impedance_MRayl"), HasSubstr("-1"), HasSubstr("0.0001 to 100")));
  EXPECT_THAT(refusalOf(overriding(R"("specularDiffuse": 1.01)")), AllOf(HasSubstr("1.01"), HasSubstr("0 to 1")));
  EXPECT_THAT(refusalOf(overriding(R"("echogenicity_dB": {"value": 9, "range": [0, 6]})")),
              AllOf(HasSubstr("echogenicity_dB"), HasSubstr("9"), HasSubstr("0 to 6")));
}

TEST(AcousticTableOverrides, WrongTypesAreRefused) {
  for (const char* value :
       {"\"0.5\"", "null", "true", "[0.5]", "{\"range\": [0, 1]}", "{\"value\": null}",
        "{\"value\": 0.5, \"range\": [1]}", "{\"value\": 0.5, \"range\": [1, 0]}", "{\"value\": 0.5, \"source\": 3}"})
    EXPECT_THAT(refusalOf(overriding(std::string("\"attenuation_dBpcmMHz\": ") + value)),
                AllOf(HasSubstr("fat"), HasSubstr("attenuation_dBpcmMHz")))
        << value;
  EXPECT_THAT(refusalOf(overriding(R"("gas": 1)")), AllOf(HasSubstr("gas"), HasSubstr("true or false")));
  EXPECT_THAT(refusalOf(overriding(R"("texture": "septum")")), HasSubstr("septa"));
  EXPECT_THAT(refusalOf(overriding(R"("layers": 3)")), HasSubstr("layers"));
}

TEST(AcousticTableOverrides, NumbersThatAreNoneAreRefused) {
  for (const char* value : {"NaN", "Infinity", "1e999"})
    EXPECT_FALSE(refusalOf(overriding(std::string("\"impedance_MRayl\": ") + value)).empty()) << value;
}

TEST(AcousticTableOverrides, UnknownNamesAreRefusedWithTheNearest) {
  EXPECT_THAT(refusalOf(overriding(R"("attenuation": 1)")),
              AllOf(HasSubstr("'attenuation'"), HasSubstr("attenuation_dBpcmMHz")));
  EXPECT_THAT(refusalOf(R"({"base": "neck", "tissue": []})"), HasSubstr("'tissues'"));
  EXPECT_THAT(refusalOf(R"({"base": "nek"})"), HasSubstr("'neck'"));
  EXPECT_THAT(refusalOf(overriding(R"("gas": true)", "\"muscel\"")), HasSubstr("'muscle'"));
  EXPECT_THAT(refusalOf(overriding(R"("gas": true)", "16")), AllOf(HasSubstr("16"), HasSubstr("0 to 15")));
  EXPECT_THAT(refusalOf(overriding(R"("gas": true)", "2.5")), HasSubstr("2.5"));
  EXPECT_THAT(refusalOf(R"({"base": "neck", "tissues": [{"gas": true}]})"), HasSubstr("label"));
}

TEST(AcousticTableOverrides, ALabelListedTwiceIsRefused) {
  EXPECT_THAT(refusalOf(R"({"base": "neck", "tissues": [{"label": "vein"}, {"label": 6}]})"),
              AllOf(HasSubstr("vein"), HasSubstr("twice")));
}

TEST(AcousticTableOverrides, LayersMustBeCompleteAndInOrder) {
  const auto layer = [](const std::string& rest) { return overriding("\"layers\": [{" + rest + "}]"); };
  EXPECT_THAT(refusalOf(layer(R"("from_mm": 0, "to_mm": 1, "echo_dB": 9, "anisotropy": 1)")),
              AllOf(HasSubstr("layer 1"), HasSubstr("patchiness")));
  EXPECT_THAT(refusalOf(layer(R"("from_mm": 1, "to_mm": 1, "echo_dB": 9, "anisotropy": 1, "patchiness": 0)")),
              AllOf(HasSubstr("from_mm"), HasSubstr("to_mm")));
}

TEST(AcousticTableOverrides, WithoutABaseEverythingIsNeeded) {
  EXPECT_THAT(refusalOf(R"({"tissues": []})"), AllOf(HasSubstr("background"), HasSubstr("base")));
  EXPECT_THAT(refusalOf(R"({"tissues": [{"label": "background"}]})"), HasSubstr("has no 'impedance_MRayl'"));
}

TEST(AcousticTableOverrides, BrokenTextIsRefused) {
  for (const char* text : {"", "{", "[]", "3", "\xff\xfe", R"({"base": 4})", R"({"base": "neck", "name": 4})"})
    EXPECT_FALSE(refusalOf(text).empty()) << text;
}

TEST(AcousticTableFile, TakesItsNameFromTheFileAndNamesTheFileInRefusals) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "mine.json") << overriding(R"("gas": false)");
  const auto mine = loadAcousticTable((folder / "mine.json").string());
  ASSERT_TRUE(mine) << mine.error().message;
  EXPECT_EQ(mine->name, "mine");

  std::ofstream(folder / "bad.json") << overriding(R"("gas": 0)");
  const auto bad = loadAcousticTable((folder / "bad.json").string());
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().message, AllOf(HasSubstr("bad.json"), HasSubstr("gas")));
}

TEST(AcousticTableFile, MissingFilesAndFoldersAreRefused) {
  const test::TemporaryFolder folder;
  for (const std::string& name : {std::string("nek"), (folder / "none.json").string(), folder.path().string()}) {
    const auto table = loadAcousticTable(name);
    ASSERT_FALSE(table);
    EXPECT_THAT(table.error().message, HasSubstr(name));
  }
}

}  // namespace
}  // namespace insonate
