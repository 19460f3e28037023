#include "HandScene.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <random>
#include <set>

namespace insonate::test {
namespace {

using testing::HasSubstr;

std::string needleFile() {
  std::ifstream file(INSONATE_SOURCE_DIR "/resources/hands/needle.json");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(TagBody, BuiltInBodiesHaveElevenTagsOfTheirOwn) {
  std::set<int> ids;
  for (const std::string& name : tagBodyNames()) {
    const TagBody body = bodyNamed(name.c_str());
    EXPECT_EQ(body.tags.size(), 11U);
    for (const BodyTag& tag : body.tags) {
      EXPECT_TRUE(ids.insert(tag.id).second) << tag.id;
      EXPECT_NEAR(determinant(tag.bodyFromTag.linear), 1, 1e-9);
      EXPECT_GT(dot(tag.bodyFromTag.linear.column[2], normalized(tag.bodyFromTag.offset)), 0.999) << "faces outward";
    }
    // The tool leaves through the face without a tag.
    for (const BodyTag& tag : body.tags)
      EXPECT_LT(dot(tag.bodyFromTag.linear.column[2], body.bodyFromTool.linear.column[2]), 0.5);
  }
  EXPECT_EQ(ids.size(), 22U);
}

TEST(TagBody, PatternsDifferInAllDirections) {
  std::set<std::string> seen;
  for (int id = 0; id < kTagCount; ++id) {
    TagPattern pattern = tagPattern(id);
    for (int turn = 0; turn < 4; ++turn) {
      TagPattern next{};
      for (int y = 0; y < kTagCellsWithBorder; ++y)
        for (int x = 0; x < kTagCellsWithBorder; ++x)
          next[std::size_t(x) * kTagCellsWithBorder + std::size_t(kTagCellsWithBorder - 1 - y)] =
              pattern[std::size_t(y) * kTagCellsWithBorder + std::size_t(x)];
      pattern = next;
      EXPECT_TRUE(seen.insert(std::string(pattern.begin(), pattern.end())).second);
    }
    EXPECT_EQ(pattern.front(), 1) << "the border is white";
    EXPECT_EQ(pattern[kTagCellsWithBorder + 1], 0) << "the outer cells are black";
  }
}

TEST(TagBody, ErrorsSayWhatIsWrong) {
  const std::string text = needleFile();
  ASSERT_TRUE(parseTagBody(text));
  const auto error = [](const std::string& json) {
    const auto body = parseTagBody(json);
    return body ? std::string("no error") : body.error().message;
  };
  EXPECT_THAT(error(replaced(text, "\"id\": 3", "\"id\": 2")), HasSubstr("appears twice"));
  EXPECT_THAT(error(replaced(text, "\"id\": 3", "\"id\": 35")), HasSubstr("id"));
  EXPECT_THAT(error(replaced(text, "\"face\": 4", "\"face\": 12")), HasSubstr("face"));
  EXPECT_THAT(error(replaced(text, "\"size_mm\": 16", "\"size_mm\": 30")), HasSubstr("does not fit"));
  EXPECT_THAT(error(replaced(text, "[0, 10, 2, 14, 8]", "[0, 8, 14, 2, 10]")), HasSubstr("counterclockwise"));
  EXPECT_THAT(error(replaced(text, "[0, 10, 2, 14, 8], ", "")),
              testing::AnyOf(HasSubstr("one side only"), HasSubstr("face")));
  EXPECT_THAT(error(replaced(text, "17.86367", "19.86367")), HasSubstr("not flat"));
  EXPECT_THAT(error(replaced(text, "\"z\": [0, 0, 1]", "\"z\": [1, 0, 0]")), HasSubstr("perpendicular"));
  EXPECT_THAT(error(replaced(text, "\"tool\"", "\"tip\"")), HasSubstr("tip"));
  EXPECT_THAT(error("{"), HasSubstr("line 1"));
}

TEST(TagBody, DamagedFilesAreRefusedOrRead) {
  const std::string text = needleFile();
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = text;
    for (unsigned k = 0; k < 1 + random() % 4; ++k) {
      const std::size_t at = random() % damaged.size();
      if (random() % 3 == 0)
        damaged.erase(at, 1 + random() % 20);
      else
        damaged[at] = "0123456789[]{},.-e\"x"[random() % 20];
    }
    const auto body = parseTagBody(damaged);
    EXPECT_TRUE(body || !body.error().message.empty());
    const std::size_t tags = body ? body->tags.size() : 0;
    for (std::size_t k = 0; k < tags; ++k) EXPECT_TRUE(isFinite(body->tags[k].bodyFromTag.offset));
  }
}

}  // namespace
}  // namespace insonate::test
