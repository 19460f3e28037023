#include "support/TestData.h"

#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace insonate {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(JsonEntry, WholeNumbersHaveNoFraction) {
  const json object = json::parse(R"({"three": 3.0, "half": 0.5, "huge": 1e300})");
  JsonEntry entry(object, "step 'a'", {"three", "half", "huge"});
  EXPECT_EQ(entry.whole("three", 0, 9), 3);
  EXPECT_EQ(entry.wholeIfThere("four", 0, 9), std::nullopt);
  EXPECT_EQ(entry.trouble(), "");
  entry.whole("half", 0, 9);
  EXPECT_EQ(entry.trouble(), "step 'a' needs a whole number as 'half', not 0.5.");
  JsonEntry other(object, "step 'a'", {"three", "half", "huge"});
  EXPECT_EQ(other.whole("huge", 0, 9), 0);
  EXPECT_THAT(other.trouble(), HasSubstr("needs a number from 0 to 9 as 'huge'"));
}

TEST(JsonEntry, ListsOfTextsAndEntriesKeepTheFirstTrouble) {
  const json object = json::parse(R"({"words": ["a", 3], "steps": [{"name": "x"}, {"name": "y"}, {"name": "x"}]})");
  JsonEntry words(object, "The file", {"words", "steps"});
  words.texts("words");
  EXPECT_EQ(words.trouble(), "The file needs texts in the list 'words', not 3.");
  JsonEntry steps(object, "The file", {"words", "steps"});
  const auto names = steps.list("steps", "step", [](const json& step, const std::string& where, std::string&) {
    return where + step["name"].get<std::string>();
  });
  EXPECT_THAT(names, testing::ElementsAre("step 'x'x", "step 'y'y", "step 'x'x"));
  EXPECT_EQ(steps.trouble(), "The file cannot be used: step 'x' is there twice; names tell them apart.");
}

TEST(JsonEntry, WhatIsNestedAHundredThousandTimesIsRefusedShortly) {
  constexpr int kDeep = 100'000;
  const json object = json::parse("{\"name\": " + std::string(kDeep, '[') + std::string(kDeep, ']') + "}");
  JsonEntry entry(object, "The file", {"name"});
  entry.text("name");
  EXPECT_EQ(entry.trouble(), "The file needs a text as 'name', not [ ... ].");
}

TEST(Preset, IsFoundByNameElseAsAFile) {
  const std::vector<Preset> presets{{"first", "one"}, {"second", "two"}};
  EXPECT_EQ(namesOf(presets), (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(presetOrFile("a thing", "second", presets)->text, "two");
  EXPECT_EQ(presetOrFile("a thing", "second", presets)->where, "");
  EXPECT_EQ(presetOrFile("a thing", "secnd", presets).error().message,
            "'secnd' is neither a thing (first, second) nor a file; did you mean 'second'?");
  const test::TemporaryFolder folder;
  std::ofstream(folder / "third.json") << "three";
  const auto file = presetOrFile("a thing", (folder / "third.json").string(), presets);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->text, "three");
  EXPECT_EQ(file->where, (folder / "third.json").string() + ": ");
}

}  // namespace
}  // namespace insonate
