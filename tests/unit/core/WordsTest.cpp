#include <insonate/core/Range.h>
#include <insonate/core/Words.h>

#include <gtest/gtest.h>

#include <cmath>

namespace insonate {
namespace {

const std::vector<std::string_view> kKnown{"depth_mm", "focus_mm", "gain_dB", "look"};

TEST(NearestWord, ForgivesTyposAndCase) {
  EXPECT_EQ(nearestWord("dept_mm", kKnown), "depth_mm");
  EXPECT_EQ(nearestWord("GAIN_db", kKnown), "gain_dB");
  EXPECT_EQ(nearestWord("lok", kKnown), "look");
}

TEST(NearestWord, ForgivesAMissingUnit) {
  EXPECT_EQ(nearestWord("depth", kKnown), "depth_mm");
  EXPECT_EQ(nearestWord("gain", kKnown), "gain_dB");
}

TEST(NearestWord, IsEmptyWhereNothingResembles) {
  EXPECT_EQ(nearestWord("temperature", kKnown), "");
  EXPECT_EQ(nearestWord("", kKnown), "");
  EXPECT_EQ(nearestWord("depth", {}), "");
}

TEST(JoinedWords, PutsCommasBetween) {
  EXPECT_EQ(joinedWords({}), "");
  EXPECT_EQ(joinedWords({"a"}), "a");
  EXPECT_EQ(joinedWords({"a", "b", "c"}), "a, b, c");
}

TEST(QuotedWords, KeepsNamesWithCommasApart) {
  EXPECT_EQ(quotedWords({}), "");
  EXPECT_EQ(quotedWords({"auto", "vein, transverse"}), "'auto', 'vein, transverse'");
}

TEST(JsonError, SaysThePlaceWithoutTheLibrary) {
  EXPECT_EQ(
      readableJsonError("[json.exception.parse_error.101] parse error at line 1, column 2: unexpected end of input"),
      "line 1, column 2: unexpected end of input");
  EXPECT_EQ(readableJsonError("[json.exception.type_error.302] type must be number, but is string"),
            "type must be number, but is string");
  EXPECT_EQ(readableJsonError("anything else"), "anything else");
}

TEST(CheckRange, NamesValueAndRange) {
  EXPECT_TRUE(checkRange(40, -40, 40, "gain_dB"));
  EXPECT_EQ(checkRange(41, -40, 40, "settings: gain_dB").error().message,
            "settings: gain_dB is 41; allowed is -40 to 40.");
  EXPECT_FALSE(checkRange(std::nan(""), -40, 40, "gain_dB"));
}

TEST(Words, TextBecomesMarkup) {
  EXPECT_EQ(escapedMarkup("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(escapedMarkup("V\u00e9ne\n\x01\x1f."), "V\u00e9ne\n.");
}

}  // namespace
}  // namespace insonate
