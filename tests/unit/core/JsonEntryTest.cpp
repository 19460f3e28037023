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
  EXPECT_EQ(entry.integer("three", 0, 9), 3);
  EXPECT_EQ(entry.optionalInteger("four", 0, 9), std::nullopt);
  EXPECT_EQ(entry.error(), "");
  entry.integer("half", 0, 9);
  EXPECT_EQ(entry.error(), "step 'a' needs a whole number as 'half', not 0.5.");
  JsonEntry other(object, "step 'a'", {"three", "half", "huge"});
  EXPECT_EQ(other.integer("huge", 0, 9), 0);
  EXPECT_THAT(other.error(), HasSubstr("needs a number from 0 to 9 as 'huge'"));
}

TEST(JsonEntry, ListsOfTextsAndEntriesKeepTheFirstError) {
  const json object = json::parse(R"({"words": ["a", 3], "steps": [{"name": "x"}, {"name": "y"}, {"name": "x"}]})");
  JsonEntry words(object, "The file", {"words", "steps"});
  words.texts("words");
  EXPECT_EQ(words.error(), "The file needs texts in the list 'words', not 3.");
  JsonEntry steps(object, "The file", {"words", "steps"});
  const auto names = steps.list("steps", "step", [](const json& step, const std::string& where, std::string&) {
    return where + step["name"].get<std::string>();
  });
  EXPECT_THAT(names, testing::ElementsAre("step 'x'x", "step 'y'y", "step 'x'x"));
  EXPECT_EQ(steps.error(), "The file cannot be used: step 'x' occurs twice. Give each a different name.");
}

TEST(JsonEntry, OnlyAnOptionalTextMayBeEmpty) {
  const json object = json::parse(R"({"title": "", "number": 3})");
  const auto refusal = [&](const char* key, bool needed) {
    JsonEntry entry(object, "The case", {"title", "number"});
    EXPECT_EQ(entry.text(key, needed), "");
    return entry.error();
  };
  EXPECT_EQ(refusal("title", false), "");
  EXPECT_EQ(refusal("none", false), "");
  EXPECT_EQ(refusal("title", true), "The case needs a text as 'title', not \"\".");
  EXPECT_EQ(refusal("number", false), "The case needs a text as 'number', not 3.");
}

TEST(JsonEntry, EntriesWithoutANameAreNumbered) {
  const json object = json::parse(R"({"steps": [{"name": ""}, {"name": ""}, {"name": "z"}]})");
  JsonEntry entry(object, "The file", {"steps"});
  std::vector<std::string> places;
  entry.forEach("steps", "step", [&](const json&, const std::string& where, std::string&) { places.push_back(where); });
  EXPECT_THAT(places, testing::ElementsAre("step 1", "step 2", "step 'z'"));
  EXPECT_EQ(entry.error(), "");
}

TEST(JsonEntry, WhatIsNestedAHundredThousandTimesIsRefusedShortly) {
  constexpr int kDeep = 100'000;
  const json object = json::parse("{\"name\": " + std::string(kDeep, '[') + std::string(kDeep, ']') + "}");
  JsonEntry entry(object, "The file", {"name"});
  entry.text("name");
  EXPECT_EQ(entry.error(), "The file needs a text as 'name', not [ ... ].");
}

TEST(JsonEntry, NumbersMayStateRangeAndSource) {
  const auto read = [](const char* value) {
    const json object = json::parse(std::string("{\"stiffness\": ") + value + "}");
    JsonEntry entry(object, "tissue 'fat'", {"stiffness"});
    const auto number = entry.optionalNumberWithSource("stiffness", 1, 9, true);
    EXPECT_EQ(number.has_value() && entry.error().empty(), entry.error().empty());
    return entry.error().empty() ? std::to_string(*number) : entry.error();
  };
  EXPECT_EQ(read("3"), std::to_string(3.0));
  EXPECT_EQ(read("\"infinity\""), "inf");
  EXPECT_EQ(read(R"({"value": 3, "range": [2, 4], "source": "a study"})"), std::to_string(3.0));
  EXPECT_EQ(read("10"), "tissue 'fat' needs a number from 1 to 9, or \"infinity\", as 'stiffness', not 10.");
  EXPECT_EQ(read(R"({"range": [2, 4]})"), "tissue 'fat', stiffness, has no 'value'.");
  EXPECT_EQ(read(R"({"value": 5, "range": [2, 4]})"),
            "tissue 'fat', stiffness, has the value 5, outside its own range 2 to 4.");
  EXPECT_EQ(read(R"({"value": 5, "range": 4})"), "tissue 'fat', stiffness, needs [low, high] as 'range', not 4.");
}

TEST(JsonEntry, ListsOfNumbersHaveTheirLengthAndRange) {
  const json object = json::parse(R"({"two": [1, 2], "text": [1, 2, "a"], "far": [1, 2, 30]})");
  const auto refusal = [&](const char* key) {
    JsonEntry entry(object, "The pose", {"two", "text", "far"});
    EXPECT_EQ(entry.numbers(key, 3, 0, 9, "[x, y, z]"), std::vector<double>(3)) << key;
    return entry.error();
  };
  EXPECT_EQ(refusal("two"), "The pose needs a list of 3 numbers, [x, y, z], as 'two', not [ ... ].");
  EXPECT_EQ(refusal("text"), "The pose needs numbers from 0 to 9 in the list 'text', not \"a\".");
  EXPECT_EQ(refusal("far"), "The pose needs numbers from 0 to 9 in the list 'far', not 30.");
  EXPECT_EQ(refusal("none"), "The pose has no 'none'.");
  JsonEntry entry(object, "The pose", {"two", "text", "far"});
  EXPECT_EQ(entry.numbers("two", 2, 0, 9), (std::vector<double>{1, 2}));
}

TEST(JsonEntry, EntriesOfAFileShareTheFirstError) {
  const json object = json::parse(R"({"name": 3})");
  std::string error;
  JsonEntry(object, "step 1", {"name"}, error).text("name");
  JsonEntry(object, "step 2", {}, error).text("name");
  EXPECT_EQ(error, "step 1 needs a text as 'name', not 3.");
}

TEST(ParsedJson, FailsWithThePlaceOfTheError) {
  EXPECT_EQ(parsedJson("[1]", "The list")->size(), 1U);
  EXPECT_THAT(parsedJson("{", "The list").error().message, testing::StartsWith("The list is not valid JSON: line 1, "));
}

TEST(Preset, IsFoundByNameElseAsAFile) {
  const std::vector<Preset> presets{{"first", "one"}, {"second", "two"}};
  EXPECT_EQ(presetNames(presets), (std::vector<std::string>{"first", "second"}));
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
