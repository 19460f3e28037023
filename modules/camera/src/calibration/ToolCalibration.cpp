#include "Rigid.h"

#include <insonate/camera/ToolCalibration.h>

#include <cmath>
#include <numbers>
#include <string>

namespace insonate {
namespace {

using camera::Matrix;

/// Solves R_i tip - pivot = -t_i for tip and pivot. Returns false if the rotations do not determine them.
bool solvePivot(const std::vector<Transform>& poses, PivotCalibration& result) {
  Matrix<6, 6> a;
  Matrix<6, 1> b;
  for (const Transform& pose : poses)
    for (int r = 0; r < 3; ++r) {
      double row[6] = {};
      for (int c = 0; c < 3; ++c) row[c] = pose.linear.column[std::size_t(c)][r];
      row[3 + r] = -1;
      for (int i = 0; i < 6; ++i) {
        b[i] -= row[i] * pose.offset[r];
        for (int j = 0; j < 6; ++j) a(i, j) += row[i] * row[j];
      }
    }
  const Matrix<6, 6> inverse = camera::inverted(a);
  // The largest variance of the tip for an error of 1 mm in a pose; rotations of 20 degrees give about 30 / poses.
  constexpr double kMaxVariance = 60;
  for (int i = 0; i < 3; ++i)
    if (!(inverse(i, i) > 0) || inverse(i, i) * double(poses.size()) > kMaxVariance) return false;
  const Matrix<6, 1> x = inverse * b;
  result.tip_body = {x[0], x[1], x[2]}, result.tip_camera = {x[3], x[4], x[5]};
  result.poses = int(poses.size());
  double sum = 0;
  for (const Transform& pose : poses) {
    const Vec3 d = pose * result.tip_body - result.tip_camera;
    sum += dot(d, d);
  }
  result.error_mm = std::sqrt(sum / double(poses.size()));
  return true;
}

}  // namespace

Result<PivotCalibration> calibratePivot(const std::vector<Transform>& cameraFromBody) {
  constexpr std::size_t kLeastPoses = 20;
  constexpr double kMaxError_mm = 2, kOutlier = 3;
  if (cameraFromBody.size() < kLeastPoses)
    return fail(
        "The camera saw the body " + std::to_string(cameraFromBody.size()) +
        " times while it was pivoted; at least 20 are needed. Pivot it for some seconds in view of the camera.");
  const std::string tilt =
      "The tool was not tilted far enough. Keep the tip in one place, and tilt the tool by 30 degrees or "
      "more to all sides.";
  PivotCalibration result;
  if (!solvePivot(cameraFromBody, result)) return fail(tilt);
  std::vector<Transform> good;
  for (const Transform& pose : cameraFromBody)
    if (norm(pose * result.tip_body - result.tip_camera) <= kOutlier * result.error_mm) good.push_back(pose);
  if (good.size() >= kLeastPoses && !solvePivot(good, result)) return fail(tilt);
  if (!(result.error_mm <= kMaxError_mm))
    return fail("The tip moved by " + std::to_string(int(std::lround(result.error_mm))) +
                " mm. Press it into a small dent, and pivot again.");
  return result;
}

Result<DeskRegistration> registerDesk(const std::vector<Transform>& cameraFromBody, const Transform& bodyFromTool) {
  constexpr std::size_t kLeastPoses = 15;
  constexpr double kMaxSpread_mm = 1, kMaxTurn_deg = 1;
  if (cameraFromBody.size() < kLeastPoses)
    return fail("The camera saw the probe too briefly. Hold it still on the outline for a second.");
  Transform mean = cameraFromBody.front() * bodyFromTool;
  double spread = 0, turn = 0;
  for (int pass = 0; pass < 4; ++pass) {
    camera::Motion sum;
    spread = turn = 0;
    for (const Transform& pose : cameraFromBody) {
      const camera::Motion motion = camera::motionBetween(mean, pose * bodyFromTool);
      sum += motion * (1 / double(cameraFromBody.size()));
      spread += dot(camera::shiftOf(motion), camera::shiftOf(motion));
      turn += dot(camera::turnOf(motion), camera::turnOf(motion));
    }
    mean = camera::movedBy(mean, sum);
  }
  const double spread_mm = std::sqrt(spread / double(cameraFromBody.size()));
  const double turn_deg = std::sqrt(turn / double(cameraFromBody.size())) * 180 / std::numbers::pi;
  if (!(spread_mm <= kMaxSpread_mm) || !(turn_deg <= kMaxTurn_deg))
    return fail("The probe moved during the registration. Hold it still on the outline for a second.");
  return DeskRegistration{mean, spread_mm};
}

}  // namespace insonate
