#include "HandScene.h"

#include <insonate/camera/BodyPose.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate::test {
namespace {

const Transform kPose{turned({1, 0.3, -0.2}, 75), {60, -20, 500}};

/// The exact corners of the tags that face the camera.
std::vector<TagDetection> exactCorners(const TagBody& body, const LensModel& lens, const Transform& cameraFromBody) {
  std::vector<TagDetection> found;
  for (const BodyTag& tag : body.tags) {
    const Transform cameraFromTag = cameraFromBody * tag.bodyFromTag;
    if (dot(cameraFromTag.linear.column[2], normalized(cameraFromTag.offset)) > -0.3) continue;
    TagDetection detection;
    detection.id = tag.id;
    const auto corners = cornersOf(tag);
    for (std::size_t i = 0; i < 4; ++i) detection.corners[i] = *project(lens, cameraFromTag * corners[i]);
    found.push_back(detection);
  }
  return found;
}

double tipError_mm(const TagBody& body, const BodyPose& pose, const Transform& truth) {
  return norm(tipOf(body, pose.cameraFromBody) - tipOf(body, truth));
}

TEST(BodyPose, ExactCornersGiveTheExactPose) {
  const LensModel lens = laptopLens();
  for (const char* name : {"needle", "probe"}) {
    const TagBody body = bodyNamed(name);
    for (const double angle : {0.0, 40.0, 90.0, 150.0, 179.0}) {
      const Transform truth{turned({0.3, 1, 0.2}, angle), {-80, 40, 450}};
      const auto pose = estimatePose(body, lens, exactCorners(body, lens, truth));
      ASSERT_TRUE(pose) << name << " " << angle;
      EXPECT_LT(tipError_mm(body, *pose, truth), 1e-5);
      EXPECT_GE(pose->tags, 2);
      EXPECT_TRUE(pose->wrongTags.empty());
      EXPECT_FALSE(pose->isAmbiguous);
    }
  }
}

TEST(BodyPose, RenderedTagsGiveThePoseOfTheRenderer) {
  SimulatedSensor sensor;
  sensor.lens = laptopLens();
  SimulatedCamera camera(sensor, 1);
  const TagBody needle = bodyNamed("needle"), probe = bodyNamed("probe");
  const Transform ofProbe{turned({1, -0.3, 0.2}, 100), {-70, 30, 520}};
  const auto found = detectAll(camera.render({atRest(needle, kPose), atRest(probe, ofProbe)}, 0));
  for (const auto& [body, truth] : {std::pair{needle, kPose}, {probe, ofProbe}}) {
    const auto pose = estimatePose(body, sensor.lens, found);
    ASSERT_TRUE(pose);
    EXPECT_GE(pose->tags, 3);
    EXPECT_LT(tipError_mm(body, *pose, truth), 2);
    EXPECT_LT(angleBetween_deg(pose->cameraFromBody.linear.column[2], truth.linear.column[2]), 0.5);
  }
}

TEST(BodyPose, ATagThatContradictsTheOthersIsLeftOut) {
  const LensModel lens = laptopLens();
  const TagBody body = bodyNamed("needle");
  auto found = exactCorners(body, lens, kPose);
  ASSERT_GE(found.size(), 4U);
  const int wrong = found[1].id;
  std::ranges::rotate(found[1].corners, found[1].corners.begin() + 1);  // read in another direction
  const auto pose = estimatePose(body, lens, found);
  ASSERT_TRUE(pose);
  EXPECT_LT(tipError_mm(body, *pose, kPose), 1e-4);
  EXPECT_THAT(pose->wrongTags, testing::ElementsAre(wrong));

  for (FramePoint& corner : found[1].corners) corner.x += 200;
  const auto elsewhere = estimatePose(body, lens, found, kPose);
  ASSERT_TRUE(elsewhere);
  EXPECT_LT(tipError_mm(body, *elsewhere, kPose), 1e-4);
}

TEST(BodyPose, TheExpectedPoseDecidesBetweenThePosesOfASingleTag) {
  const LensModel lens = laptopLens();
  const TagBody body = bodyNamed("needle");
  // The tag is small and far away, so that both poses fit within the noise.
  const Transform truth{turned({1, 0.3, -0.2}, 75), {10, -20, 900}};
  auto found = exactCorners(body, lens, truth);
  found.resize(1);
  const auto alone = estimatePose(body, lens, found);
  ASSERT_TRUE(alone);
  EXPECT_TRUE(alone->isAmbiguous);
  const auto helped = estimatePose(body, lens, found, truth);
  ASSERT_TRUE(helped);
  EXPECT_LT(tipError_mm(body, *helped, truth), 1);
}

TEST(BodyPose, WithoutTagsOfTheBodyThereIsNoPose) {
  const LensModel lens = laptopLens();
  const TagBody needle = bodyNamed("needle"), probe = bodyNamed("probe");
  EXPECT_FALSE(estimatePose(needle, lens, {}));
  EXPECT_FALSE(estimatePose(needle, lens, exactCorners(probe, lens, kPose), kPose));
}

TEST(BodyPose, DegenerateCornersAreRefused) {
  const LensModel lens = laptopLens();
  const TagBody body = bodyNamed("needle");
  TagDetection point, line;
  point.corners.fill({300, 300});
  line.id = 3, line.corners = {{{100, 100}, {110, 110}, {120, 120}, {130, 130}}};
  for (const auto& found : {std::vector{point}, std::vector{line}, std::vector{point, line}}) {
    const auto pose = estimatePose(body, lens, found);
    EXPECT_TRUE(!pose || isFinite(pose->cameraFromBody.offset));
  }
}

}  // namespace
}  // namespace insonate::test
