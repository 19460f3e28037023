#include "ToolGrids.h"

#include <insonate/segmentation/Brush.h>
#include <insonate/segmentation/Guide.h>
#include <insonate/segmentation/Recipe.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Guide neck() {
  const auto guide = readGuide(guidePresets().front().text);
  EXPECT_TRUE(guide) << guide.error().message;
  return guide.value_or(Guide{});
}

const GuideStep& stepNamed(const Guide& guide, const std::string& name) {
  return *std::ranges::find(guide.steps, name, &GuideStep::name);
}

TEST(Guide, TheNecksStepsSayWhatToDoAndMakeWhatARecipeCanHold) {
  const Guide guide = neck();
  ASSERT_GE(guide.steps.size(), 5u);
  EXPECT_EQ(guide.steps.front().clicks, 0) << "it begins with what the CT tells by itself";
  const CtVolume ct(test::toolGrids()[0].geometry, 150);
  for (const GuideStep& step : guide.steps) {
    EXPECT_FALSE(step.instruction.empty() || step.lookFor.empty() || step.ifWrong.empty()) << step.name;
    std::vector<Vec3> clicks_mm;
    for (int n = 0; n < step.clicks; ++n) clicks_mm.push_back({0, 0, -12 + 8.0 * n});
    const auto way = methodFor(step, clicks_mm, ct);
    ASSERT_TRUE(way) << way.error().message;
    const auto again = readRecipe(textOf({step.title, way->steps}));
    ASSERT_TRUE(again) << step.name << ": " << again.error().message;
  }
}

TEST(Guide, WithContrastAVesselIsTrackedAndWithoutATube) {
  const Guide guide = neck();
  const GuideStep& vein = stepNamed(guide, "vein-right");
  const std::array clicks_mm{Vec3{0, 0, -12}, Vec3{0, 0, -4}, Vec3{0, 0, 4}, Vec3{0, 0, 12}};
  const auto with = methodFor(vein, clicks_mm, CtVolume(test::toolGrids()[0].geometry, 180));
  const auto without = methodFor(vein, clicks_mm, CtVolume(test::toolGrids()[0].geometry, 42));
  ASSERT_TRUE(with && without);
  EXPECT_EQ(nameOf(with->steps.front().tool), "vessel");
  EXPECT_EQ(nameOf(without->steps.front().tool), "tube");
  EXPECT_THAT(std::get<step::Tube>(without->steps.front().tool).points_mm, testing::ElementsAreArray(clicks_mm));
  EXPECT_EQ(with->steps.front().label, kVein);
  EXPECT_THAT(with->caution, IsEmpty());
  EXPECT_THAT(without->caution, HasSubstr("no contrast agent"));
}

TEST(Guide, AVesselWithoutContrastNeedsFourClicks) {
  const Guide guide = neck();
  const GuideStep& vein = stepNamed(guide, "vein-right");
  const CtVolume bright(test::toolGrids()[0].geometry, 180), pale(test::toolGrids()[0].geometry, 42);
  const std::array clicks_mm{Vec3{0, 0, -12}, Vec3{0, 0, 0}, Vec3{0, 0, 12}};
  EXPECT_EQ(clicksNeeded(vein, {}, pale), 2);
  EXPECT_EQ(clicksNeeded(vein, std::array{Vec3{900, 0, 0}}, pale), 2) << "beside the CT";
  EXPECT_EQ(clicksNeeded(vein, clicks_mm, bright), 2);
  EXPECT_EQ(clicksNeeded(vein, clicks_mm, pale), 4);
  EXPECT_EQ(clicksNeeded(stepNamed(guide, "thyroid"), clicks_mm, pale), 2);
  EXPECT_TRUE(methodFor(vein, clicks_mm, bright));
  const auto refused = methodFor(vein, clicks_mm, pale);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("needs 4 clicks or more, since the CT shows no contrast agent there"));
}

TEST(Guide, RequiredStepsComeFirst) {
  const Guide guide = neck();
  EXPECT_TRUE(std::ranges::is_sorted(guide.steps, {}, &GuideStep::optional));
}

TEST(Guide, StepsThatGrowStayNearTheClicks) {
  const Guide guide = neck();
  const auto way = methodFor(stepNamed(guide, "thyroid"), std::array{Vec3{1, 2, 3}, Vec3{-4, 5, 6}},
                             CtVolume(test::toolGrids()[0].geometry, 110));
  ASSERT_TRUE(way) << way.error().message;
  for (const LabelStep& step : way->steps)
    EXPECT_THAT(step.box_mm, testing::Optional(ElementsAre(Vec3{-19, -13, -12}, Vec3{16, 20, 21})));
}

TEST(Guide, RefusesTooFewClicksAndClicksBesideTheCt) {
  const Guide guide = neck();
  const GuideStep& vein = stepNamed(guide, "vein-right");
  const CtVolume ct(test::toolGrids()[0].geometry, 42);
  EXPECT_THAT(methodFor(vein, std::array{Vec3{}}, ct).error().message,
              HasSubstr("Jugular vein, right needs 2 clicks or more. Click in"));
  EXPECT_THAT(methodFor(vein, std::array{Vec3{}, Vec3{900, 0, 0}}, ct).error().message, HasSubstr("outside the CT"));
}

TEST(Guide, RefusesClicksThatNoWayIsFor) {
  const auto guide = readGuide(R"({"steps": [{"name": "v", "title": "Vein", "label": "vein", "say": "Click.",
    "look_for": "l", "if_wrong": "i", "clicks": 2, "least_clicks": 2,
    "ways": [{"clicks_HU": [100, 300], "steps": [{"tool": "vessel", "label": "vein"}]}]}]})");
  ASSERT_TRUE(guide) << guide.error().message;
  const auto refused =
      methodFor(guide->steps[0], std::array{Vec3{}, Vec3{0, 0, 9}}, CtVolume(test::toolGrids()[0].geometry, 42));
  EXPECT_THAT(refused.error().message, HasSubstr("The clicks lie on 42 HU"));
}

std::string refusal(const std::string& text) {
  const auto guide = readGuide(text);
  return guide ? "accepted" : guide.error().message;
}

std::string stepRefusal(const std::string& more) {
  return refusal(R"({"steps": [{"name": "a", "title": "A", "say": "s", "look_for": "l", "if_wrong": "i", )" + more +
                 "}]}");
}

TEST(Guide, BadGuidesAreRefusedWithThePlace) {
  EXPECT_THAT(refusal("{"), HasSubstr("The guide is not valid JSON"));
  EXPECT_THAT(refusal("{}"), HasSubstr("has no steps"));
  EXPECT_THAT(stepRefusal(R"("ways": [])"), HasSubstr("has an empty list 'ways'"));
  EXPECT_THAT(stepRefusal(R"("ways": [{"steps": []}])"), HasSubstr("has no steps"));
  EXPECT_THAT(stepRefusal(R"("ways": [{"steps": [{"tool": "vesel", "label": "vein"}]}])"),
              HasSubstr("did you mean 'vessel'"));
  EXPECT_THAT(stepRefusal(R"("ways": [{"steps": [{"tool": "vessel", "label": "vein", "points_mm": [[0, 0, 0]]}]}])"),
              HasSubstr("needs a list of 2 or more points"));
  EXPECT_THAT(stepRefusal(R"("clicks": 2, "ways": [{"steps": [{"tool": "auto"}]}])"),
              HasSubstr("has clicks but no 'label'"));
  EXPECT_THAT(
      stepRefusal(R"("clicks": 2, "least_clicks": 3, "label": "vein", "ways": [{"steps": [{"tool": "auto"}]}])"),
      HasSubstr("more clicks in 'least_clicks'"));
  EXPECT_THAT(stepRefusal(R"("diameter_mm": [9, 3], "ways": [{"steps": [{"tool": "auto"}]}])"),
              HasSubstr("[from, to]"));
  EXPECT_THAT(stepRefusal(R"("apart": ["airway and lungs"], "ways": [{"steps": [{"tool": "auto"}]}])"),
              HasSubstr("did you mean 'airway and lung'"));
}

/// A straight vein along z, from -14 to 14 mm.
class GuideDoubts : public test::OnGrids {
 protected:
  LabelMap veinOf(double radius_mm) const {
    LabelMap labels(grid(), kMuscle);
    const Selection inside = shape([=](Vec3 p) { return std::hypot(p.x, p.y) <= radius_mm && std::abs(p.z) <= 14; });
    for (std::size_t v = 0; v < labels.voxels.size(); ++v)
      if (inside.mask.voxels[v]) labels.voxels[v] = kVein;
    return labels;
  }
  const Guide guide = neck();
  const GuideStep& vein = stepNamed(guide, "vein-right");
  const std::array<Vec3, 2> clicks_mm{Vec3{0, 0, -14}, Vec3{0, 0, 14}};
};
INSONATE_ON_GRIDS(GuideDoubts);

std::vector<std::string> textsAbout(const GuideStep& step, std::span<const Vec3> clicks_mm, const LabelMap& labels) {
  std::vector<std::string> texts;
  for (const GuideFinding& finding : checkGuideStep(step, clicks_mm, labels)) texts.push_back(finding.text);
  return texts;
}

TEST_P(GuideDoubts, AVeinOfUsualWidthIsNotDoubted) {
  EXPECT_THAT(textsAbout(vein, clicks_mm, veinOf(5)), IsEmpty());
}

TEST_P(GuideDoubts, AThinOneIsDoubtedWithItsDiameter) {
  EXPECT_THAT(textsAbout(vein, clicks_mm, veinOf(1.6)), ElementsAre(HasSubstr("the usual range is 5 to 25 mm.")));
}

TEST_P(GuideDoubts, OneThatLiesAgainstTheAirwayIsDoubted) {
  LabelMap labels = veinOf(5);
  const Selection airway = shape([](Vec3 p) { return p.x > 5 || (p.x > 2 && std::hypot(p.x, p.y) > 5); });
  for (std::size_t v = 0; v < labels.voxels.size(); ++v)
    if (airway.mask.voxels[v] && labels.voxels[v] != kVein) labels.voxels[v] = kAirway;
  EXPECT_THAT(textsAbout(vein, clicks_mm, labels), ElementsAre(HasSubstr("of its surface touch the airway")));
}

TEST_P(GuideDoubts, AWidthThatJumpsAndAGapAreDoubted) {
  // Grids whose slices lie across the vein have sections.
  const Vec3 across = grid().direction.column[2];
  if (std::abs(across.z) < 0.9) GTEST_SKIP() << "the vein runs along the slices of this grid";
  LabelMap labels = veinOf(5);
  const Selection wide = shape([](Vec3 p) { return std::hypot(p.x, p.y) <= 11 && p.z > 1 && p.z < 6; });
  for (std::size_t v = 0; v < labels.voxels.size(); ++v)
    if (wide.mask.voxels[v]) labels.voxels[v] = kVein;
  EXPECT_THAT(textsAbout(vein, clicks_mm, labels), testing::Contains(HasSubstr("The width changes from")));

  LabelMap broken = veinOf(5);
  const Selection gap = shape([](Vec3 p) { return std::abs(p.z) < 3; });
  for (std::size_t v = 0; v < broken.voxels.size(); ++v)
    if (gap.mask.voxels[v]) broken.voxels[v] = kMuscle;
  EXPECT_THAT(textsAbout(vein, clicks_mm, broken), testing::Contains(HasSubstr("between your clicks")));
}

TEST_P(GuideDoubts, AVesselThatIsTooNarrowOrTooWideAtOnePlaceIsDoubted) {
  const Vec3 across = grid().direction.column[2];
  if (std::abs(across.z) < 0.9) GTEST_SKIP() << "the vessel runs along the slices of this grid";
  // A cone, so that neither the mean width nor any change within a few millimeters is unusual.
  const auto coneOf = [&](double from_mm, double to_mm) {
    LabelMap labels(grid(), kMuscle);
    const Selection inside = shape([&](Vec3 p) {
      return std::abs(p.z) <= 14 && std::hypot(p.x, p.y) <= from_mm + (to_mm - from_mm) * (p.z + 14) / 28;
    });
    for (std::size_t v = 0; v < labels.voxels.size(); ++v)
      if (inside.mask.voxels[v]) labels.voxels[v] = kArtery;
    return labels;
  };
  const GuideStep& carotid = stepNamed(guide, "artery-right");
  EXPECT_THAT(textsAbout(carotid, clicks_mm, coneOf(3, 3.5)), IsEmpty());
  EXPECT_THAT(textsAbout(carotid, clicks_mm, coneOf(1, 7.5)), testing::Contains(HasSubstr("mm wide at z =")));
  EXPECT_THAT(textsAbout(carotid, clicks_mm, coneOf(0.4, 4)), testing::Contains(HasSubstr("is only")));
}

TEST_P(GuideDoubts, ClicksOnTheOtherSideOfTheAirwayAreDoubted) {
  const auto withAirway = [this](double side) {
    LabelMap labels = veinOf(5);
    const Selection there = shape([=](Vec3 p) { return std::hypot(p.x - side * 12, p.y - 4) <= 3; });
    for (std::size_t v = 0; v < labels.voxels.size(); ++v)
      if (there.mask.voxels[v]) labels.voxels[v] = kAirway;
    return labels;
  };
  EXPECT_THAT(textsAbout(vein, clicks_mm, withAirway(1)), IsEmpty()) << "the airway is to the left of a right vein";
  EXPECT_THAT(textsAbout(vein, clicks_mm, withAirway(-1)),
              ElementsAre(HasSubstr("on the patient's left; this step is for the right")));
}

TEST_P(GuideDoubts, ClicksWithoutTheVeinAreDoubted) {
  EXPECT_THAT(textsAbout(vein, clicks_mm, LabelMap(grid(), kMuscle)),
              ElementsAre("Nothing is labeled where you clicked."));
  const std::array aside{Vec3{0, 0, -14}, Vec3{12, 0, 0}, Vec3{0, 0, 14}};
  EXPECT_THAT(textsAbout(vein, aside, veinOf(6)),
              testing::Contains(HasSubstr("Click 2 at (12.0, 0.0, 0.0) mm lies outside the result. Move each")));
}

TEST_P(GuideDoubts, AVesselWithoutItsClicksCannotBeAccepted) {
  const auto canBeAccepted = [](const std::vector<GuideFinding>& findings) {
    return std::ranges::all_of(findings, &GuideFinding::canBeAccepted);
  };
  EXPECT_FALSE(canBeAccepted(checkGuideStep(vein, clicks_mm, LabelMap(grid(), kMuscle))));
  const std::array aside{Vec3{0, 0, -14}, Vec3{12, 0, 0}, Vec3{0, 0, 14}};
  EXPECT_FALSE(canBeAccepted(checkGuideStep(vein, aside, veinOf(6))));
  EXPECT_TRUE(canBeAccepted(checkGuideStep(vein, clicks_mm, veinOf(1.6)))) << "thin, but where the author clicked";
}

TEST(GuideDoubtsOfAll, WhatTheAutomaticStepShouldHaveFoundIsNamed) {
  const Guide guide = neck();
  LabelMap labels(test::toolGrids()[0].geometry, kMuscle);
  labels.voxels[0] = kSkin, labels.voxels[1] = kFat, labels.voxels[2] = kBone;
  EXPECT_THAT(textsAbout(guide.steps.front(), {}, labels), ElementsAre(HasSubstr("There is no airway")));
}

}  // namespace
}  // namespace insonate
