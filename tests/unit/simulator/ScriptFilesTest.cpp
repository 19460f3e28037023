#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ScriptedSession.h>

#include <gmock/gmock.h>

#include <fstream>
#include <map>

namespace insonate {
namespace {

using testing::HasSubstr;

/// Their results are tested by script_library_test, which takes minutes.
TEST(ScriptFiles, EachFitsTheTextbookNeckOrAnotherRegion) {
  const auto neck = makePhantom("textbook", 1), chest = makePhantom("subclavian", 1);
  ASSERT_TRUE(neck && chest);
  std::map<std::string, PatientCase> regions;
  for (const auto& [procedure, variant] : std::initializer_list<std::pair<const char*, const char*>>{
           {"axillary", "axillary"}, {"basilic", "arm"}, {"femoral", "groin"}})
    regions.emplace(procedure, *makePhantom(variant, 1));
  EXPECT_GE(sessionScriptNames().size(), 20u);
  for (const std::string& name : sessionScriptNames()) {
    SCOPED_TRACE(name);
    if (const auto region = regions.find(name.substr(0, name.find('-'))); region != regions.end()) {
      const auto fitting = loadSessionScript(name, region->second);
      ASSERT_TRUE(fitting) << fitting.error().message;
      EXPECT_EQ(fitting->procedure, region->first + (name.ends_with("-line") ? "_line" : ""));
      continue;
    }
    const auto script = loadSessionScript(name, *neck);
    if (script) {
      EXPECT_EQ(script->procedure, name.starts_with("line-") ? "internal_jugular_line" : "internal_jugular");
      continue;
    }
    EXPECT_THAT(script.error().message,
                HasSubstr("The script '" + name +
                          "' does not fit this case: The script cannot be used: act 2 has a probe that cannot"));
    const auto below = loadSessionScript(name, *chest);
    ASSERT_TRUE(below) << below.error().message;
    EXPECT_EQ(below->procedure, "subclavian");
  }
}

TEST(ScriptFiles, NamesAndFiles) {
  const test::TemporaryFolder folder;
  const PatientCase nobody;
  EXPECT_THAT(loadSessionScript("figure-99", nobody).error().message,
              testing::AllOf(HasSubstr("'figure-99' is neither a script ("), HasSubstr("did you mean 'figure-")));
  std::ofstream(folder / "mine.json") << R"({"acts": [{"wait_s": 1}]})";
  EXPECT_TRUE(loadSessionScript((folder / "mine.json").string(), nobody));
  std::ofstream(folder / "bad.json") << "{";
  EXPECT_THAT(loadSessionScript((folder / "bad.json").string(), nobody).error().message,
              HasSubstr("bad.json: The script is not valid JSON"));
}

}  // namespace
}  // namespace insonate
