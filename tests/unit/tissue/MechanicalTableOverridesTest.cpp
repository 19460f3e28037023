#include "support/TestData.h"

#include <insonate/tissue/MechanicalTable.h>

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

namespace insonate {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

MechanicalTable parsedMechanics(const std::string& text) {
  auto table = parseMechanicalTable(text);
  EXPECT_TRUE(table) << table.error().message;
  return table.value_or(MechanicalTable{});
}

std::string mechanicsRefusalOf(const std::string& text) {
  const auto table = parseMechanicalTable(text);
  EXPECT_FALSE(table) << text;
  return table ? "" : table.error().message;
}

std::string mechanicsOverriding(const std::string& fields, const std::string& label = "\"fat\"") {
  return R"({"base": "measured", "tissues": [{"label": )" + label + ", " + fields + "}]}";
}

TEST(MechanicalTableOverrides, ReplaceOnlyWhatTheyName) {
  const MechanicalTable measured = *loadMechanicalTable("measured");
  MechanicalTable expected = measured;
  expected.tissues[kVein].wall_mm = 0.6;
  const MechanicalTable table = parsedMechanics(mechanicsOverriding(R"("wall_mm": 0.6)", "\"vein\""));
  EXPECT_EQ(table.tissues, expected.tissues);
}

TEST(MechanicalTableOverrides, TakeInfinityPlainAndAnnotated) {
  EXPECT_TRUE(std::isinf(parsedMechanics(mechanicsOverriding(R"("young_kPa": "infinity")")).of(kFat).young_kPa));
  EXPECT_TRUE(std::isinf(
      parsedMechanics(
          mechanicsOverriding(R"("young_kPa": {"value": "infinity", "range": [100, "infinity"], "source": "own"})"))
          .of(kFat)
          .young_kPa));
  EXPECT_EQ(
      parsedMechanics(mechanicsOverriding(R"("young_kPa": {"value": 7, "range": [5, "infinity"]})")).of(kFat).young_kPa,
      7);
}

TEST(MechanicalTableOverrides, InfinityIsForYoungsModulusOfSolidsOnly) {
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("poisson": "infinity")")),
              AllOf(HasSubstr("poisson"), HasSubstr("0 to 0.499")));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("wallYoung_kPa": "infinity")", "2")),
              HasSubstr("wallYoung_kPa"));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("young_kPa": "infinite")")), HasSubstr("or \"infinity\""));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("young_kPa": {"value": 5, "range": ["infinity", 4]})")),
              HasSubstr("range"));
}

TEST(MechanicalTableOverrides, AnotherKindNeedsItsNumbersAndDropsTheOld) {
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("kind": "solid")", "\"vein\"")),
              AllOf(HasSubstr("vein"), HasSubstr("has no 'young_kPa'")));
  const MechanicalTissue solid =
      parsedMechanics(mechanicsOverriding(R"("kind": "solid", "young_kPa": 23, "poisson": 0.45)", "\"vein\""))
          .of(kVein);
  EXPECT_EQ(solid, (MechanicalTissue{.kind = Mechanics::Solid, .young_kPa = 23, .poisson = 0.45}));
  EXPECT_EQ(parsedMechanics(mechanicsOverriding(R"("kind": "rigid")")).of(kFat).kind, Mechanics::Rigid);
}

TEST(MechanicalTableOverrides, NumbersOfAnotherKindAreRefused) {
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("young_kPa": 5)", "\"bone\"")),
              AllOf(HasSubstr("young_kPa"), HasSubstr("rigid")));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("wall_mm": 1)")),
              AllOf(HasSubstr("wall_mm"), HasSubstr("solid")));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("kind": "gas", "poisson": 0.4)")),
              AllOf(HasSubstr("poisson"), HasSubstr("gas")));
}

TEST(MechanicalTableOverrides, RefusalNamesTissueFieldValueAndRange) {
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("young_kPa": 0)")),
              AllOf(HasSubstr("fat"), HasSubstr("young_kPa"), HasSubstr("0.01 to 1e+08")));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("poisson": 0.5)")),
              AllOf(HasSubstr("not 0.5"), HasSubstr("0 to 0.499")));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("pressure_kPa": 93)", "\"artery\"")),
              AllOf(HasSubstr("93"), HasSubstr("50")));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("young_kPa": {"value": 9, "range": [1, 6]})")),
              HasSubstr("1 to 6"));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("kind": "liquid")")),
              HasSubstr("the unknown kind 'liquid'; did you mean"));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("kind": 2)")), HasSubstr("kind"));
}

TEST(MechanicalTableOverrides, WrongTypesAndNumbersThatAreNoneAreRefused) {
  for (const char* value :
       {"\"5\"", "null", "true", "[5]", "{}", "{\"value\": null}", "{\"value\": 5, \"range\": [1]}",
        "{\"value\": 5, \"range\": [6, 4]}", "{\"value\": 5, \"source\": 3}", "NaN", "Infinity", "1e999", "-1"})
    EXPECT_FALSE(mechanicsRefusalOf(mechanicsOverriding(std::string("\"young_kPa\": ") + value)).empty()) << value;
}

TEST(MechanicalTableOverrides, UnknownNamesAreRefusedWithTheNearest) {
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("young": 1)")),
              AllOf(HasSubstr("'young'"), HasSubstr("'young_kPa'")));
  EXPECT_THAT(mechanicsRefusalOf(R"({"base": "mesured"})"), AllOf(HasSubstr("mechanics"), HasSubstr("'measured'")));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("kind": "gas")", "\"muscel\"")), HasSubstr("'muscle'"));
  EXPECT_THAT(mechanicsRefusalOf(mechanicsOverriding(R"("kind": "gas")", "16")), HasSubstr("0 to 15"));
  EXPECT_THAT(mechanicsRefusalOf(R"({"base": "measured", "tissues": [{"label": "vein"}, {"label": 6}]})"),
              HasSubstr("twice"));
}

TEST(MechanicalTableOverrides, WithoutABaseEverythingIsNeeded) {
  EXPECT_THAT(mechanicsRefusalOf(R"({"tissues": []})"), AllOf(HasSubstr("background"), HasSubstr("base")));
  EXPECT_THAT(mechanicsRefusalOf(R"({"tissues": [{"label": "background"}]})"),
              HasSubstr("has no 'kind'; it is one of solid, rigid, lumen, gas."));
  EXPECT_THAT(mechanicsRefusalOf(R"({"tissues": [{"label": "fat", "kind": "solid", "young_kPa": 3}]})"),
              HasSubstr("has no 'poisson'"));
}

TEST(MechanicalTableOverrides, BrokenTextIsRefused) {
  for (const char* text : {"", "{", "[]", "3", "\xff\xfe", R"({"base": 4})", R"({"base": "measured", "name": 4})",
                           R"({"base": "measured", "tissues": 4})", R"({"base": "measured", "sources": {"a": 1}})"})
    EXPECT_FALSE(mechanicsRefusalOf(text).empty()) << text;
}

TEST(MechanicalTableFile, TakesItsNameFromTheFileAndNamesTheFileInRefusals) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "mine.json") << mechanicsOverriding(R"("young_kPa": 2)");
  const auto mine = loadMechanicalTable((folder / "mine.json").string());
  ASSERT_TRUE(mine) << mine.error().message;
  EXPECT_EQ(mine->name, "mine");
  EXPECT_EQ(mine->of(kFat).young_kPa, 2);

  std::ofstream(folder / "bad.json") << mechanicsOverriding(R"("young_kPa": -2)");
  const auto bad = loadMechanicalTable((folder / "bad.json").string());
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().message, AllOf(HasSubstr("bad.json"), HasSubstr("young_kPa")));
}

TEST(MechanicalTableFile, MissingFilesAndFoldersAreRefused) {
  const test::TemporaryFolder folder;
  for (const std::string& name : {std::string("theses"), (folder / "none.json").string(), folder.path().string()}) {
    const auto table = loadMechanicalTable(name);
    ASSERT_FALSE(table);
    EXPECT_THAT(table.error().message, AllOf(HasSubstr(name), HasSubstr("mechanics"), Not(HasSubstr("neck"))));
  }
}

}  // namespace
}  // namespace insonate
