#include <insonate/simulator/VesselNaming.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <cmath>

namespace insonate {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr std::uint8_t kOwn = 200;
const OwnLabels kOwnVein{{kOwn, {.name = "drawn vein", .tissue = kVein}}};

/// Along z at y = 0: a vein of 5 mm radius at x = -12, an elliptic one (8 by 3 mm) at x = 12.
LabelMap twoVeins(std::uint8_t label = kVein) {
  VolumeGeometry g;
  g.size = {101, 61, 51};
  g.spacing_mm = {0.5, 0.5, 1};
  g.origin_mm = {-25, -15, -25};
  LabelMap labels(g, kMuscle);
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vec3 p = g.patientFromIndex() * Vec3{double(i), double(j), double(k)};
        if (std::hypot(p.x + 12, p.y) <= 5 || std::hypot((p.x - 12) / 8, p.y / 3) <= 1) labels.at(i, j, k) = label;
      }
  return labels;
}

TEST(VesselNaming, ACourseRunsAlongTheMiddleWithTheRadiusOfItsSection) {
  const auto vessel = nameVessel(twoVeins(), {}, {-10, 2, 5}, "right internal jugular vein");
  ASSERT_TRUE(vessel) << vessel.error().message;
  EXPECT_EQ(vessel->name, "right internal jugular vein");
  EXPECT_EQ(vessel->label, kVein);
  ASSERT_GT(vessel->course.size(), 30u);
  for (const NamedVessel::Point& point : vessel->course) {
    if (std::abs(point.position_mm.z) > 15) continue;  // not at the ends
    EXPECT_NEAR(std::hypot(point.position_mm.x + 12, point.position_mm.y), 0, 0.3);
    EXPECT_NEAR(point.radius_mm, 5, 0.15);
  }
}

TEST(VesselNaming, TheRadiusOfAFlatVesselIsThatOfACircleOfItsArea) {
  const auto vessel = nameVessel(twoVeins(), {}, {18, 0, 0}, "left internal jugular vein");
  ASSERT_TRUE(vessel) << vessel.error().message;
  const auto& middle = vessel->course[vessel->course.size() / 2];
  EXPECT_NEAR(middle.position_mm.x, 12, 0.5);
  EXPECT_NEAR(middle.radius_mm, std::sqrt(8.0 * 3), 0.2);
}

TEST(VesselNaming, ALabelOfTheAuthorsOwnThatIsAVeinCanBeNamed) {
  const auto vessel = nameVessel(twoVeins(kOwn), kOwnVein, {-12, 0, 0}, "v");
  ASSERT_TRUE(vessel) << vessel.error().message;
  EXPECT_EQ(vessel->label, kVein);
}

TEST(VesselNaming, APlaceInNoVesselIsRefused) {
  EXPECT_THAT(nameVessel(twoVeins(), {}, {0, 10, 0}, "right internal jugular vein").error().message,
              HasSubstr("right internal jugular vein is in no vein or artery"));
  EXPECT_THAT(nameVessel(twoVeins(), {}, {0, 0, 900}, "v").error().message, HasSubstr("in no vein or artery"));
}

TEST(VesselNaming, AVesselIsSplitWhereItsNameChanges) {
  const NamedVessel whole{"right internal jugular vein",
                          kVein,
                          {{{0, 0, 0}, 5}, {{0, 0, 10}, 5}, {{0, 0, 20}, 6}},
                          {{1, 0, 3}, {0, 0, 18}}};
  const auto parts = splitVessel(whole, {3, 0, 11});
  ASSERT_TRUE(parts) << parts.error().message;
  EXPECT_THAT(parts->first.course, SizeIs(2));
  EXPECT_THAT(parts->second.course, SizeIs(2));
  EXPECT_EQ(parts->first.course.back(), parts->second.course.front());
  EXPECT_EQ(parts->first.clicks_mm, (std::vector<Vec3>{{1, 0, 3}}));
  EXPECT_EQ(parts->second.clicks_mm, (std::vector<Vec3>{{0, 0, 18}}));
  EXPECT_THAT(splitVessel(whole, {0, 0, 21}).error().message,
              HasSubstr("at an end of the right internal jugular vein"));
}

TEST(VesselNaming, AGuidesStepNamesTheVesselThatItLabeled) {
  const auto guide = readGuide(guidePresets().front().text);
  ASSERT_TRUE(guide) << guide.error().message;
  LabelStep made;
  made.label = kVein, made.of = "vein-right";
  made.tool = step::Tube{.points_mm = {{-12, 0, -20}, {-12, 0, 20}}};
  LabelStep painted = made;  // at a place that is not vein any more
  painted.of = "vein-left", painted.tool = step::Tube{.points_mm = {{0, 12, -20}, {0, 12, 20}}};
  const auto vessels = vesselsFromGuide(*guide, {.description = "", .steps = {made, painted}}, twoVeins(), {});
  ASSERT_TRUE(vessels) << vessels.error().message;
  ASSERT_THAT(*vessels, SizeIs(1));
  EXPECT_EQ(vessels->front().name, "right internal jugular vein");
  EXPECT_NEAR(vessels->front().course[20].position_mm.x, -12, 0.5);
  EXPECT_EQ(vessels->front().clicks_mm, (std::vector<Vec3>{{-12, 0, -20}, {-12, 0, 20}}));
}

TEST(VesselNaming, AVesselNamedAgainReplacesTheFirst) {
  std::vector<NamedVessel> vessels{{"a", kVein, {{{}, 1}}}, {"b", kVein, {{{}, 1}}}};
  addOrReplaceVessel({"a", kVein, {{{}, 2}}}, vessels);
  addOrReplaceVessel({"c", kVein, {{{}, 3}}}, vessels);
  ASSERT_THAT(vessels, SizeIs(3));
  EXPECT_EQ(vessels[0].course[0].radius_mm, 2);
}

}  // namespace
}  // namespace insonate
