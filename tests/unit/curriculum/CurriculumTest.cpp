#include "AttemptMaker.h"
#include "support/TestData.h"

#include <insonate/curriculum/Curriculum.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using namespace std::string_literals;
using testing::ElementsAre;
using testing::HasSubstr;

/// A curriculum of two levels, with a piece of its text replaced.
std::string courseWith(const std::string& piece, const std::string& other) {
  std::string text = R"({"name": "course", "title": "A course", "version": 2, "levels": [
    {"name": "first", "title": "First", "about": "Begin.", "case": "textbook", "procedure": "internal_jugular",
     "position": "supine", "assistance": "guided", "prerequisites": [],
     "pass": {"leastPoints": 50, "mastery_percent": 90,
              "standards": [{"metric": "passes", "most": 2, "otherwise": "too many passes", "source": "S"},
                            {"metric": "nearest_lung_mm", "version": 3, "least": 5, "otherwise": "too near"}]},
     "mastery": {"passesInARow": 3, "cusum": {"acceptable": 0.1, "unacceptable": 0.25, "limit": 2.5},
                 "lapsesAfter_days": 180, "lapsesAfter": {"failures": 2, "within": 3}, "source": "M"}},
    {"name": "second", "title": "Second", "about": "Go on.", "case": "textbook", "procedure": "internal_jugular",
     "assistance": "test", "prerequisites": ["first"], "pass": {}, "mastery": {"passesInARow": 1}}]})";
  const auto at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return text.replace(at, piece.size(), other);
}

std::string refusalOf(const std::string& text) {
  const auto curriculum = parseCurriculum(text);
  EXPECT_FALSE(curriculum) << text;
  return curriculum ? "" : curriculum.error().message;
}

TEST(Curriculum, IsReadAsItIsWritten) {
  const auto curriculum = parseCurriculum(courseWith("first", "first"));
  ASSERT_TRUE(curriculum) << curriculum.error().message;
  EXPECT_EQ(curriculum->version, 2);
  const Level& level = curriculum->levels.at(0);
  EXPECT_EQ(level.position, "supine");
  EXPECT_EQ(level.assistance, Assistance::Guided);
  EXPECT_EQ(level.pass.minPoints, 50);
  EXPECT_EQ(level.pass.mastery_percent, 90);
  ASSERT_EQ(level.pass.standards.size(), 2U);
  EXPECT_EQ(level.pass.standards[0].maximum, 2);
  EXPECT_EQ(level.pass.standards[1].minimum, 5);
  EXPECT_EQ(level.pass.standards[1].version, 3);
  EXPECT_EQ(level.mastery.consecutivePasses, 3);
  EXPECT_EQ(level.mastery.cusum, (CusumRule{0.1, 0.25, 2.5}));
  EXPECT_EQ(level.mastery.lapsesAfter_days, 180);
  EXPECT_EQ(level.mastery.lapsesAfter, (FailureRule{2, 3}));
  EXPECT_EQ(curriculum->levels[1].pass, PassRule{});
  EXPECT_EQ(curriculum->levels[1].prerequisites, std::vector<std::string>{"first"});
}

TEST(Curriculum, ItsTextIsReadAsTheSame) {
  for (const std::string& text :
       {courseWith("first", "first"), courseWith("\"A course\"", R"("A \u00e4 \"course\"")")}) {
    const auto curriculum = parseCurriculum(text);
    ASSERT_TRUE(curriculum) << curriculum.error().message;
    const auto again = parseCurriculum(curriculumText(*curriculum));
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(*again, *curriculum);
  }
  const auto preset = loadCurriculum("central_line");
  ASSERT_TRUE(preset) << preset.error().message;
  EXPECT_EQ(*parseCurriculum(curriculumText(*preset)), *preset);
}

TEST(Curriculum, BadInputIsToldWhereAndWhatElse) {
  struct Case {
    const char *piece, *other, *sentence;
  };
  for (const Case& c : std::initializer_list<Case>{
           {"{\"name\": \"course\"", "{{", "The curriculum is not valid JSON: line 1"},
           {"\"title\": \"A course\",", "", "The curriculum has no 'title'."},
           {"\"course\"", "\"a course/\"", "The curriculum needs a 'name' (short name) of at most 64 letters"},
           {"\"version\": 2", "\"version\": 1.5", "The curriculum needs a whole number as 'version', not 1.5."},
           {"\"guided\"", "\"guide\"", "level 'first' has the unknown assistance 'guide'; did you mean 'guided'?"},
           {"\"mastery_percent\": 90", "\"mastery_percent\": 101",
            "level 'first', pass, needs a number from 1 to 100 as 'mastery_percent', not 101."},
           {"\"mastery_percent\": 90", "\"mastery_percent\": -5", "not -5."},
           {"\"most\": 2", "\"most\": 2, \"least\": 1", "level 'first', standard 1 needs one of 'least' and 'most'."},
           {"\"most\": 2, ", "", "level 'first', standard 1 needs one of 'least' and 'most'."},
           {"\"otherwise\": \"too many passes\"", "\"otherwise\": \"\"", "needs a text as 'otherwise'"},
           {"\"passesInARow\": 3", "\"passesInARow\": 0", "level 'first', mastery, needs a number from 1 to 100"},
           {"\"unacceptable\": 0.25", "\"unacceptable\": 0.1",
            "level 'first', cusum, needs a rate of failure as 'acceptable' that is below the 'unacceptable' one."},
           {"\"limit\": 2.5", "\"limit\": 0", "level 'first', cusum, needs a number from 0.01 to 100 as 'limit'"},
           {"\"within\": 3", "\"within\": 1", "it would never lapse."},
           {"\"lapsesAfter_days\": 180", "\"lapsesAfter_days\": 0", "as 'lapsesAfter_days', not 0."},
           {"[\"first\"]", "[\"frist\"]", "level 'second' has the unknown prerequisite 'frist'; did you mean 'first'?"},
           {"[\"first\"]", "[\"first\", \"first\"]", "level 'second' has the prerequisite 'first' twice."},
           {"[\"first\"]", "[7]", "level 'second' needs texts in the list 'prerequisites', not 7."},
           {"[\"first\"]", "[\"second\"]", "form a circle: 'second' needs 'second'; remove one"},
           {"\"prerequisites\": []", "\"prerequisites\": [\"second\"]",
            "form a circle: 'first' needs 'second', 'second' needs 'first'; remove one of these prerequisites."},
           {"\"name\": \"second\"", "\"name\": \"first\"", "level 'first' occurs twice"},
           {"\"pass\": {}", "\"pass\": []", "level 'second', pass, must be an object"},
           {"\"case\"", "\"caes\"", "level 'first' has an unknown 'caes'; did you mean 'case'?"}})
    EXPECT_THAT(refusalOf(courseWith(c.piece, c.other)), HasSubstr(c.sentence)) << c.other;
  EXPECT_THAT(refusalOf(R"({"name": "c", "title": "C", "version": 1})"), HasSubstr("has no levels"));
  EXPECT_THAT(refusalOf("[]"), HasSubstr("must be an object"));
  EXPECT_THAT(refusalOf("{\"name\": " + std::string(100'000, '[')), HasSubstr("is not valid JSON"));
}

TEST(Curriculum, LevelsComeInAnOrderInWhichTheyCanBeLearnt) {
  const auto level = [](const std::string& name, const std::string& needed) {
    return R"({"name": ")" + name + R"(", "title": "T", "about": "A.", "case": "c", "procedure": "p",
      "assistance": "test", "prerequisites": [)" +
           needed + R"(], "pass": {}, "mastery": {"passesInARow": 1}})";
  };
  const auto curriculum =
      parseCurriculum(R"({"name": "c", "title": "C", "version": 1, "levels": [)" + level("d", R"("b", "c")") + "," +
                      level("c", R"("a")") + "," + level("b", R"("a")") + "," + level("a", "") + "]}");
  ASSERT_TRUE(curriculum) << curriculum.error().message;
  std::vector<std::string> names;
  for (const Level& l : curriculum->levels) names.push_back(l.name);
  EXPECT_THAT(names, ElementsAre("a", "c", "b", "d"));
  EXPECT_EQ(curriculum->level("b")->name, "b");
  EXPECT_EQ(curriculum->level("e"), nullptr);
}

TEST(Curriculum, TooManyLevelsAreRefused) {
  std::string levels;
  for (int i = 0; i < 201; ++i)
    levels += (i ? "," : "") + R"({"name": "l)"s + std::to_string(i) + R"(", "title": "T", "about": "A.", "case": "c",
      "procedure": "p", "assistance": "test", "prerequisites": [], "pass": {}, "mastery": {"passesInARow": 1}})";
  EXPECT_THAT(refusalOf(R"({"name": "c", "title": "C", "version": 1, "levels": [)" + levels + "]}"),
              HasSubstr("has 201 levels; 200 is the maximum."));
}

TEST(Curriculum, FilesAndNames) {
  EXPECT_EQ(curriculumPresetNames(), std::vector<std::string>{"central_line"});
  EXPECT_THAT(loadCurriculum("centralline").error().message, HasSubstr("did you mean 'central_line'?"));
  const test::TemporaryFolder folder;
  std::ofstream(folder / "c.json") << courseWith("first", "first");
  EXPECT_TRUE(loadCurriculum((folder / "c.json").string()));
  std::ofstream(folder / "d.json") << "{}";
  EXPECT_THAT(loadCurriculum((folder / "d.json").string()).error().message,
              HasSubstr("d.json: The curriculum has no 'name'"));
}

}  // namespace
}  // namespace insonate
