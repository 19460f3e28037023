#include "HandScene.h"
#include "Rigid.h"

#include <insonate/camera/LensCalibration.h>
#include <insonate/camera/ToolCalibration.h>

#include <gmock/gmock.h>

#include <random>

namespace insonate::test {
namespace {

using testing::HasSubstr;

/// Directions and places in which a user shows the board, in the camera frame; the board faces the camera.
Transform boardPose(int i) {
  const Mat3 facing{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}};
  const double tilt = i % 3 == 0 ? 0 : 28;
  const Vec3 axis{std::cos(i * 1.3), std::sin(i * 1.3), 0.2};
  return {turned(axis, tilt) * facing, {110.0 * std::cos(i * 2.4), 60.0 * std::sin(i * 2.4), 420.0 + 25 * (i % 4)}};
}

std::vector<TagDetection> boardCorners(const LensModel& lens, const Transform& cameraFromBoard, double noise_px,
                                       std::mt19937& random) {
  std::normal_distribution<double> normal(0, 1);
  std::vector<TagDetection> found;
  for (const BodyTag& tag : lensBoard()) {
    TagDetection detection;
    detection.id = tag.id;
    const auto corners = cornersOf(tag);
    bool isInside = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto pixel = project(lens, cameraFromBoard * (tag.bodyFromTag * corners[i]));
      isInside = isInside && pixel && pixel->x > 0 && pixel->y > 0 && pixel->x < lens.width && pixel->y < lens.height;
      if (pixel) detection.corners[i] = {pixel->x + noise_px * normal(random), pixel->y + noise_px * normal(random)};
    }
    if (isInside) found.push_back(detection);
  }
  return found;
}

/// The largest distance between the pixels at which two lenses show the same directions, in the part of the image that
/// is more than a share of its size away from its edge.
double difference_px(const LensModel& a, const LensModel& b, double margin) {
  double most = 0;
  for (double v = margin; v <= 1 - margin; v += 0.05)
    for (double u = margin; u <= 1 - margin; u += 0.05) {
      const double x = u * a.width, y = v * a.height;
      const auto p = project(b, rayThrough(a, {x, y}) * 500);
      most = std::max(most, p ? std::hypot(p->x - x, p->y - y) : 1e9);
    }
  return most;
}

TEST(LensCalibration, ExactCornersGiveTheExactLens) {
  const LensModel lens = laptopLens();
  std::mt19937 random(1);
  LensCalibrator calibrator(lens.width, lens.height);
  for (int i = 0; i < 16; ++i) calibrator.add(boardCorners(lens, boardPose(i), 0, random));
  EXPECT_GE(calibrator.views(), LensCalibrator::kLeastViews);
  const auto found = calibrator.calibrate();
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->lens.fx_px, lens.fx_px, 0.01);
  EXPECT_NEAR(found->lens.cy_px, lens.cy_px, 0.01);
  EXPECT_NEAR(found->lens.k1, lens.k1, 1e-4);
  EXPECT_NEAR(found->lens.p1, lens.p1, 1e-5);
  EXPECT_LT(found->error_px, 1e-3);
}

TEST(LensCalibration, NoiseOfCornersMovesTheLensLittle) {
  const LensModel lens = laptopLens();
  std::mt19937 random(2);
  LensCalibrator calibrator(lens.width, lens.height);
  for (int i = 0; i < 24; ++i) calibrator.add(boardCorners(lens, boardPose(i), 0.15, random));
  const auto found = calibrator.calibrate();
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(difference_px(lens, found->lens, 0.05), 2.5);
  EXPECT_LT(difference_px(lens, found->lens, 0.25), 1.5);
  EXPECT_NEAR(found->lens.fx_px, lens.fx_px, 3);
  EXPECT_NEAR(found->error_px, 0.15 * std::sqrt(2), 0.03);
}

TEST(LensCalibration, RefusesTooFewSimilarAndParallelImages) {
  const LensModel lens = laptopLens();
  std::mt19937 random(3);
  LensCalibrator calibrator(lens.width, lens.height);
  EXPECT_EQ(calibrator.add(std::vector<TagDetection>{}), BoardView::kNoBoard);
  EXPECT_EQ(calibrator.add(boardCorners(lens, boardPose(1), 0, random)), BoardView::kTaken);
  EXPECT_EQ(calibrator.add(boardCorners(lens, boardPose(1), 0.1, random)), BoardView::kSimilar);
  EXPECT_THAT(calibrator.calibrate().error().message, HasSubstr("1 images"));
  LensCalibrator parallel(lens.width, lens.height);
  const LensModel pinhole = lensWithoutDistortion(lens.width, lens.height, 68);
  for (int i = 0; i < 12; ++i)
    parallel.add(boardCorners(
        pinhole, {{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}}, {-100 + 20.0 * i, 8.0 * (i % 3), 500}}, 0,
        random));
  EXPECT_THAT(parallel.calibrate().error().message, HasSubstr("Tilt the board"));
}

TEST(LensCalibration, FindsTheBoardInARenderedImage) {
  SimulatedSensor sensor;
  sensor.lens = scaledLens(laptopLens(), 960, 540);
  SimulatedCamera camera(sensor, 4);
  TagBody board;
  board.name = "board";
  for (const double z : {0.0, -1.0})
    for (const auto& [x, y] : {std::pair{-90.0, -120.0}, {90.0, -120.0}, {90.0, 120.0}, {-90.0, 120.0}})
      board.vertices_mm.push_back({x, y, z});
  board.faces = {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  board.tags = lensBoard();
  LensCalibrator calibrator(sensor.lens.width, sensor.lens.height);
  EXPECT_EQ(calibrator.add(camera.render({atRest(board, boardPose(1))}, 0)), BoardView::kTaken);
}

std::vector<Transform> pivotPoses(Vec3 tip_body, double tilt_deg, double noise_mm, std::mt19937& random) {
  std::normal_distribution<double> normal(0, 1);
  const Vec3 pivot{30, 120, 480};
  std::vector<Transform> poses;
  for (int i = 0; i < 80; ++i) {
    const Mat3 rotation =
        turned({std::cos(i * 0.7), std::sin(i * 0.7), 0}, tilt_deg * (0.5 + 0.5 * std::sin(i * 0.31))) *
        turned({0, 1, 0.3}, 70);
    const Vec3 noise = Vec3{normal(random), normal(random), normal(random)} * noise_mm;
    poses.push_back({rotation, pivot - rotation * tip_body + noise});
  }
  return poses;
}

TEST(ToolCalibration, PivotingFindsTheTip) {
  std::mt19937 random(5);
  const Vec3 tip{2.5, -1.5, 86};
  const auto exact = calibratePivot(pivotPoses(tip, 35, 0, random));
  ASSERT_TRUE(exact) << exact.error().message;
  EXPECT_LT(norm(exact->tip_body - tip), 1e-9);
  EXPECT_LT(norm(exact->tip_camera - Vec3{30, 120, 480}), 1e-9);
  auto noisy = pivotPoses(tip, 35, 0.2, random);
  noisy[10].offset = noisy[10].offset + Vec3{15, 0, 0};  // a pose that was measured wrong
  const auto found = calibratePivot(noisy);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(norm(found->tip_body - tip), 0.3);
  EXPECT_EQ(found->poses, 79);
}

TEST(ToolCalibration, PivotingRefusesWhatCannotGiveATip) {
  std::mt19937 random(6);
  const Vec3 tip{0, 0, 85};
  EXPECT_THAT(calibratePivot({}).error().message, HasSubstr("0 times"));
  EXPECT_THAT(calibratePivot(pivotPoses(tip, 3, 0.1, random)).error().message, HasSubstr("not tilted"));
  EXPECT_THAT(calibratePivot(pivotPoses(tip, 35, 6, random)).error().message, HasSubstr("The tip moved"));
}

TEST(ToolCalibration, TheDeskIsTheMeanPoseOfTheProbeOnTheOutline) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 1);
  const TagBody probe = bodyNamed("probe");
  const Transform truth{turned({1, 0.2, 0}, 110), {20, 150, 520}};
  std::vector<Transform> poses;
  for (int i = 0; i < 40; ++i) {
    const camera::Motion shake{{0.2 * normal(random), 0.2 * normal(random), 0.2 * normal(random), 2e-4 * normal(random),
                                2e-4 * normal(random), 2e-4 * normal(random)}};
    poses.push_back(camera::movedBy(truth * inverted(probe.bodyFromTool), shake));
  }
  const auto desk = registerDesk(poses, probe.bodyFromTool);
  ASSERT_TRUE(desk) << desk.error().message;
  EXPECT_LT(norm(desk->cameraFromDesk.offset - truth.offset), 0.15);
  EXPECT_LT(angleBetween_deg(desk->cameraFromDesk.linear.column[2], truth.linear.column[2]), 0.02);
  poses[3].offset.x += 20;
  EXPECT_THAT(registerDesk(poses, probe.bodyFromTool).error().message, HasSubstr("still"));
  EXPECT_THAT(registerDesk({}, probe.bodyFromTool).error().message, HasSubstr("briefly"));
}

TEST(Rigid, RotationVectorsComeBack) {
  for (const double angle : {0.0, 1e-9, 0.3, 1.5, 3.0, 3.14159})
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0.3, -1, 0.2}, Vec3{-1, -1, -1}}) {
      const Vec3 w = normalized(axis) * angle;
      EXPECT_LT(norm(camera::rotationVector(camera::rotationBy(w)) - w), 1e-7) << angle;
    }
}

}  // namespace
}  // namespace insonate::test
