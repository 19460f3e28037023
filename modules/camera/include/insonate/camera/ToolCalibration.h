#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>

#include <vector>

namespace insonate {

/// Tip of a tool, found by pivoting.
struct PivotCalibration {
  Vec3 tip_body;        ///< body frame, mm
  Vec3 tip_camera;      ///< the point about which the tool was pivoted, camera frame, mm
  double error_mm = 0;  ///< root mean square distance of the tip from this point
  int poses = 0;        ///< number of poses used
};

/// Computes the tip of a tool from poses of its body while the tip stays in one place and the tool is tilted in all
/// directions (linear least squares). Poses that contradict the others are left out. Fails with a sentence if there are
/// fewer than 20 poses, if the tool was tilted by less than about 20 degrees or in one plane only, or if the tip moved.
Result<PivotCalibration> calibratePivot(const std::vector<Transform>& cameraFromBody);

/// Position of the desk.
struct DeskRegistration {
  Transform cameraFromDesk;
  double spread_mm = 0;  ///< root mean square distance of the tool from its mean position
};

/// Computes the pose of the desk from poses of the probe's body while the user holds the probe still on the printed
/// outline. The desk frame is the probe frame on the outline: origin in the middle of the outline, x toward its arrow,
/// z down into the desk. Fails with a sentence if there are fewer than 15 poses, or if the probe moved by more than 1
/// mm or turned by more than 1 degree (root mean square).
Result<DeskRegistration> registerDesk(const std::vector<Transform>& cameraFromBody, const Transform& bodyFromTool);

}  // namespace insonate
