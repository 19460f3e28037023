#include <insonate/curriculum/CurriculumDraft.h>
#include <insonate/curriculum/LevelSituations.h>
#include <insonate/teaching/TeachingHere.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Curriculum preset() {
  return *loadCurriculum("central_line");
}

std::vector<DraftError> errors(const Curriculum& draft) {
  return findDraftErrors(draft, *teachingNames());
}

std::vector<std::string> levelsOf(const std::vector<DraftError>& found) {
  std::vector<std::string> levels;
  for (const DraftError& one : found) levels.push_back(one.level);
  return levels;
}

TEST(CurriculumDraft, WhatIsFinishedHasNoErrorAndIsReadAsItIs) {
  EXPECT_THAT(errors(preset()), IsEmpty());
  EXPECT_EQ(*parseDraft(curriculumText(preset())), preset());
}

TEST(CurriculumDraft, WhatIsNotFinishedIsReadAsItWasWritten) {
  Curriculum draft = preset();
  draft.title.clear();
  draft.levels[0].title.clear(), draft.levels[0].about.clear(), draft.levels[0].caseName.clear();
  draft.levels[0].procedure.clear(), draft.levels[0].pass.standards[0].otherwise.clear();
  draft.levels[0].prerequisites = {draft.levels[1].name};
  draft.levels[2].mastery.cusum = CusumRule{0.4, 0.1, 2}, draft.levels[2].mastery.lapsesAfter = FailureRule{4, 3};
  std::ranges::reverse(draft.levels);
  const auto read = parseDraft(curriculumText(draft));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, draft);
  EXPECT_FALSE(parseCurriculum(curriculumText(draft)));
  draft.levels.clear();
  EXPECT_EQ(*parseDraft(curriculumText(draft)), draft);
}

TEST(CurriculumDraft, WhatIsNoDraftIsRefused) {
  for (const char* text : {"", "{}", "[]", "{ \"name\": \"a b\", \"version\": 1 }", "{ \"name\": \"a\" }",
                           "{ \"name\": \"a\", \"version\": 1, \"levels\": [ 7 ] }"})
    EXPECT_FALSE(parseDraft(text)) << text;
}

TEST(CurriculumDraft, EachLevelTellsItsErrorAndTheWholeItsOwn) {
  Curriculum draft = preset();
  draft.title.clear();
  draft.levels[1].about.clear();
  draft.levels[2].caseName = "Mr X";
  draft.levels[3].mastery.cusum = CusumRule{0.4, 0.1, 2};
  const auto found = errors(draft);
  EXPECT_THAT(levelsOf(found), ElementsAre(draft.levels[1].name, draft.levels[2].name, draft.levels[3].name, ""));
  EXPECT_THAT(found[0].sentence, HasSubstr("has no 'about'"));
  EXPECT_THAT(found[1].sentence, HasSubstr("unknown case 'Mr X'"));
  EXPECT_THAT(found[2].sentence, HasSubstr("below the 'unacceptable'"));
  EXPECT_THAT(found[3].sentence, HasSubstr("has no 'title'"));
}

TEST(CurriculumDraft, CirclesNoLevelsAndTwinsAreTold) {
  Curriculum draft = preset();
  draft.levels[0].prerequisites = {draft.levels[1].name};
  ASSERT_EQ(errors(draft).size(), 1U);
  EXPECT_THAT(errors(draft)[0].sentence, HasSubstr("form a circle: 'jugular_first' needs 'jugular_alone'"));
  draft = preset();
  draft.levels.push_back(draft.levels.back());
  EXPECT_EQ(errors(draft).size(), 1U);
  draft.levels.clear();
  ASSERT_EQ(errors(draft).size(), 1U);
  EXPECT_THAT(errors(draft)[0].sentence, HasSubstr("add the first one"));
}

using When = LevelSituation::When;

std::string turn(const std::vector<LevelSituation>& story, When when) {
  const auto found = std::ranges::find(story, when, &LevelSituation::when);
  return found == story.end() ? "(left out)" : found->sentence;
}

TEST(LevelStory, TellsWhatATraineeReadsFromBeginningToLapse) {
  Curriculum curriculum = preset();
  curriculum.levels[1].mastery.lapsesAfter_days = 90;
  const auto story = levelSituations(curriculum, "jugular_alone");
  EXPECT_EQ(turn(story, When::Beginning),
            "Locked: master 'First jugular line' (0 of 2 passed attempts in a row) first.");
  EXPECT_EQ(turn(story, When::Reached), "Unlocked: no attempt counts yet; 2 passed attempts in a row master it.");
  EXPECT_THAT(turn(story, When::AfterFailure),
              HasSubstr("Unlocked: 0 of 2 passed attempts in a row; the last attempt failed because"));
  EXPECT_EQ(turn(story, When::AfterPass), "Unlocked: 1 of 2 passed attempts in a row; the last attempt passed.");
  EXPECT_THAT(turn(story, When::Mastered),
              HasSubstr("Mastered with 2 passed attempts in a row; it lapses after 90 days"));
  EXPECT_THAT(turn(story, When::Lapsed), HasSubstr("Lapsed: more than 90 days without practice"));
}

TEST(LevelStory, EachLevelOfThePresetCanBeMastered) {
  const Curriculum curriculum = preset();
  for (const Level& level : curriculum.levels) {
    const auto story = levelSituations(curriculum, level.name);
    EXPECT_THAT(turn(story, When::Mastered), HasSubstr("Mastered with ")) << level.name;
    EXPECT_EQ(turn(story, When::Lapsed) != "(left out)", level.mastery.lapsesAfter_days.has_value()) << level.name;
  }
}

TEST(LevelStory, FollowsLcCusumUpToAHighLimit) {
  Curriculum curriculum = preset();
  curriculum.levels = {curriculum.levels.front()};
  curriculum.levels[0].mastery.cusum = CusumRule{0.1, 0.25, 20};
  const auto story = levelSituations(curriculum, curriculum.levels[0].name);
  EXPECT_THAT(turn(story, When::Beginning), HasSubstr("a learning score (LC-CUSUM) of 20.00"));
  EXPECT_THAT(turn(story, When::AfterPass), HasSubstr("is 0.18 of 20.00"));
  EXPECT_THAT(turn(story, When::Mastered), HasSubstr("has reached 20.00"));
}

TEST(LevelStory, LeavesOutWhatTheRulesNeverReach) {
  Curriculum curriculum = preset();
  curriculum.levels = {curriculum.levels.front()};
  Level& level = curriculum.levels[0];
  level.pass.mastery_percent = 100;
  level.pass.standards = {{.metric = "passes", .minimum = 3, .otherwise = "few"},
                          {.metric = "passes", .maximum = 1, .otherwise = "many"}};
  const auto story = levelSituations(curriculum, level.name);
  EXPECT_EQ(turn(story, When::Mastered), "(left out)") << "nobody can meet both limits";
  EXPECT_THAT(turn(story, When::AfterFailure), HasSubstr("Unlocked: "));
}

}  // namespace
}  // namespace insonate
