#include "support/SmallCase.h"

#include <insonate/simulator/PoseChecks.h>
#include <insonate/simulator/ProbePose.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ImagingSetup setup() {
  ImagingSetup setup;
  setup.probe = *loadProbe("linear");
  setup.settings = settingsFor(setup.probe);
  setup.settings.depth_mm = 30;
  return setup;
}

std::vector<std::string> warningsAt(std::vector<Vec3> faces_mm, const ImagingSetup& s = setup()) {
  std::vector<Transform> path;
  for (const Vec3 face : faces_mm) path.push_back(*patientFromProbe(face, {0, 1, 0}, {1, 0, 0}));
  return poseWarnings(test::smallCase(), s, path);
}

TEST(PoseChecks, SaysNothingOnTheSkin) {
  EXPECT_THAT(warningsAt({{0, 0, 0}}), IsEmpty());
  EXPECT_THAT(warningsAt({{0, 4, 0}}), IsEmpty()) << "pressed in";
}

TEST(PoseChecks, AFaceInsideTheBody) {
  EXPECT_THAT(warningsAt({{0, 20, 0}}), Contains(HasSubstr("15 mm inside the body")));
}

TEST(PoseChecks, AFaceOffTheSkin) {
  EXPECT_THAT(warningsAt({{0, -35, 0}}), Contains(HasSubstr("30 mm off the skin")));
  EXPECT_THAT(warningsAt({{0, -25, 0}}), testing::Each(testing::Not(HasSubstr("off the skin"))));
}

TEST(PoseChecks, AFieldOutsideTheScan) {
  EXPECT_THAT(warningsAt({{24, 0, 0}}), ElementsAre(HasSubstr("outside the scan")));
}

TEST(PoseChecks, PosesOfAPathShareASentence) {
  const auto warnings = warningsAt({{0, 0, 0}, {24, 0, 0}, {30, 0, 0}});
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("At poses 1, 2"), HasSubstr("outside the scan"))));
}

TEST(PoseChecks, AFocusBelowThePicture) {
  ImagingSetup deep = setup();
  deep.settings.focus_mm = 35;
  EXPECT_THAT(warningsAt({{0, 0, 0}}, deep), ElementsAre(AllOf(HasSubstr("35 mm"), HasSubstr("30 mm"))));
}

}  // namespace
}  // namespace insonate
