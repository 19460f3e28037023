#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/simulator/ProbePose.h>

#include <gmock/gmock.h>

#include <fstream>
#include <limits>

namespace insonate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

void expectNear(Vec3 a, Vec3 b, double tolerance = 1e-12) {
  EXPECT_LT(norm(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(PatientFromProbe, AxesAreLateralElevationAxialAndRightHanded) {
  const auto pose = patientFromProbe({1, 2, 3}, {0, 5, 0}, {2, 0, 0});
  ASSERT_TRUE(pose);
  expectNear(*pose * Vec3{0, 0, 0}, {1, 2, 3});
  expectNear(pose->linear * Vec3{1, 0, 0}, {1, 0, 0});
  expectNear(pose->linear * Vec3{0, 0, 1}, {0, 1, 0});
  expectNear(pose->linear * Vec3{0, 1, 0}, cross({0, 1, 0}, {1, 0, 0}));
  EXPECT_NEAR(determinant(pose->linear), 1, 1e-12);
}

TEST(PatientFromProbe, MakesLateralSquareToAxialAndKeepsAxial) {
  const auto pose = patientFromProbe({}, {1, 2, 3}, {0.3, -0.1, 0.9});
  ASSERT_TRUE(pose);
  const auto& [x, y, z] = pose->linear.column;
  expectNear(z, normalized({1, 2, 3}));
  for (const double product : {dot(x, y), dot(y, z), dot(z, x)}) EXPECT_NEAR(product, 0, 1e-12);
  for (const Vec3 axis : {x, y, z}) EXPECT_NEAR(norm(axis), 1, 1e-12);
  EXPECT_GT(dot(x, Vec3{0.3, -0.1, 0.9}), 0);
}

TEST(PatientFromProbe, TakesDirectionsOfAnyLength) {
  for (const double length : {1e-200, 1e200}) {
    const auto pose = patientFromProbe({}, Vec3{0, 1, 0} * length, Vec3{1, 1, 0} * length);
    ASSERT_TRUE(pose) << length;
    expectNear(pose->linear.column[0], {1, 0, 0});
  }
}

TEST(PatientFromProbe, RefusesWhatGivesNoFrame) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [](Vec3 position_mm, Vec3 axial, Vec3 lateral) {
    const auto pose = patientFromProbe(position_mm, axial, lateral);
    return pose ? std::string() : pose.error().message;
  };
  EXPECT_THAT(refusal({nan, 0, 0}, {0, 1, 0}, {1, 0, 0}), HasSubstr("finite"));
  EXPECT_THAT(refusal({}, {0, HUGE_VAL, 0}, {1, 0, 0}), HasSubstr("finite"));
  EXPECT_THAT(refusal({}, {0, 0, 0}, {1, 0, 0}), HasSubstr("axial must not be zero"));
  EXPECT_THAT(refusal({}, {0, 1, 0}, {0, 0, 0}), HasSubstr("lateral must not be zero"));
  EXPECT_THAT(refusal({}, {0, 1, 0}, {0, -3, 0}), HasSubstr("parallel"));
  EXPECT_THAT(refusal({}, {0, 1, 0}, {1e-9, 1, 0}), HasSubstr("parallel"));
}

TEST(PatientFromProbe, PoseOfIsItsInverse) {
  const auto pose = patientFromProbe({1, 2, 3}, {1, 2, 3}, {1, 0, 0});
  const StartPose back = toStartPose(*pose);
  const auto again = patientFromProbe(back.position_mm, back.axial, back.lateral);
  for (int axis = 0; axis < 3; ++axis) expectNear(pose->linear.column[axis], again->linear.column[axis]);
  expectNear(pose->offset, again->offset);
}

constexpr const char* kPose = R"({"position_mm": [1, 2, 3], "axial": [0, 1, 0], "lateral": [1, 0, 0]})";

PosePath read(const std::string& text, const PatientCase& patient = test::smallCase()) {
  auto path = readPoses(text, patient);
  EXPECT_TRUE(path) << path.error().message;
  return path.value_or(PosePath{{Transform{}}, false, {}});
}

std::string refusalOf(const std::string& text) {
  const auto path = readPoses(text, test::smallCase());
  EXPECT_FALSE(path) << text;
  return path ? "" : path.error().message;
}

TEST(ReadPoses, InlineJsonIsOnePose) {
  const PosePath path = read(std::string(" ") + kPose);
  EXPECT_FALSE(path.isPath);
  ASSERT_EQ(path.patientFromProbe.size(), 1u);
  expectNear(path.patientFromProbe[0].offset, {1, 2, 3});
}

TEST(ReadPoses, AListIsAPathHoweverShort) {
  const std::string pose = kPose;
  for (const std::string& text : {"[" + pose + "]", "{\"poses\": [" + pose + "]}"}) {
    const PosePath path = read(text);
    EXPECT_TRUE(path.isPath);
    EXPECT_EQ(path.patientFromProbe.size(), 1u);
  }
  EXPECT_EQ(read("[" + pose + "," + pose + "]").patientFromProbe.size(), 2u);
}

TEST(ReadPoses, TakesAFile) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "pose.json") << kPose;
  expectNear(read((folder / "pose.json").string()).patientFromProbe[0].offset, {1, 2, 3});
}

TEST(ReadPoses, TakesAStartPoseByNameAndAuto) {
  PatientCase patient = test::smallCase();
  patient.manifest.startPoses.push_back({"deep", {4, 5, 6}, {0, 1, 0}, {0, 0, 1}});
  expectNear(read("deep", patient).patientFromProbe[0].offset, {4, 5, 6});
  expectNear(read("auto", patient).patientFromProbe[0].offset, {0, 0, 0});
}

TEST(ReadPoses, RefusesASickStartPoseOfTheCase) {
  PatientCase patient = test::smallCase();
  patient.manifest.startPoses[0].axial = {0, 0, 0};
  const auto path = readPoses("over the vein", patient);
  ASSERT_FALSE(path);
  EXPECT_THAT(path.error().message, AllOf(HasSubstr("over the vein"), HasSubstr("axial")));
}

TEST(ReadPoses, RefusalsNamePoseAndField) {
  EXPECT_THAT(refusalOf(R"({"position_mm": [1, 2, 3], "axial": [0, 1, 0]})"), HasSubstr("The pose has no 'lateral'."));
  EXPECT_THAT(refusalOf(R"({"position_mm": [1, 2], "axial": [0, 1, 0], "lateral": [1, 0, 0]})"),
              HasSubstr("position_mm"));
  EXPECT_THAT(refusalOf(R"({"position_mm": [1, 2, null], "axial": [0, 1, 0], "lateral": [1, 0, 0]})"),
              HasSubstr("null"));
  EXPECT_THAT(refusalOf(R"({"position": [1, 2, 3], "axial": [0, 1, 0], "lateral": [1, 0, 0]})"),
              HasSubstr("'position_mm'"));
  EXPECT_THAT(refusalOf(R"({"position_mm": [NaN, 2, 3], "axial": [0, 1, 0], "lateral": [1, 0, 0]})"),
              HasSubstr("JSON"));
  const std::string pose = kPose;
  EXPECT_THAT(refusalOf("[" + pose + R"(, {"position_mm": [1, 2, 3], "axial": [0, 0, 0], "lateral": [1, 0, 0]}])"),
              AllOf(HasSubstr("pose 1"), HasSubstr("axial must not be zero")));
  EXPECT_THAT(refusalOf("[]"), HasSubstr("at least one"));
  EXPECT_THAT(refusalOf("[3]"), HasSubstr("pose 0"));
  EXPECT_FALSE(refusalOf("{").empty());
}

TEST(ReadPoses, AWordThatIsNothingIsRefusedWithTheKnownNames) {
  EXPECT_THAT(refusalOf("over the artery"), AllOf(HasSubstr("'auto'"), HasSubstr("'over the vein'")));
  EXPECT_FALSE(refusalOf("").empty());
  EXPECT_FALSE(refusalOf("/").empty());
}

TEST(ReadPoses, SaysWhatWasStraightenedAndFoundAutomatically) {
  EXPECT_THAT(read(kPose).warnings, testing::IsEmpty());
  EXPECT_THAT(read(R"({"position_mm": [1, 2, 3], "axial": [0, 1, 0], "lateral": [1, 0.01, 0]})").warnings,
              testing::IsEmpty());
  EXPECT_THAT(read(R"([{"position_mm": [1, 2, 3], "axial": [0, 1, 0], "lateral": [1, 1, 0]}])").warnings,
              testing::ElementsAre(AllOf(HasSubstr("pose 0"), HasSubstr("45 degrees"))));
  EXPECT_THAT(read("auto").warnings, testing::IsEmpty()) << "the case's own start pose";
  PatientCase patient = test::smallCase();
  patient.manifest.startPoses.clear();
  patient.manifest.targets.clear();
  EXPECT_THAT(read("auto", patient).warnings,
              testing::ElementsAre(AllOf(HasSubstr("found automatically"), HasSubstr("z = "))));
}

TEST(ReadPoses, ParseErrorsSayWhereWithoutTheLibrary) {
  EXPECT_THAT(refusalOf("{"), AllOf(HasSubstr("line 1, column 2"), testing::Not(HasSubstr("exception"))));
}

}  // namespace
}  // namespace insonate
