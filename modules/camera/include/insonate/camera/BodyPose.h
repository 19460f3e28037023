#pragma once

#include <insonate/camera/LensModel.h>
#include <insonate/camera/TagBody.h>
#include <insonate/camera/TagDetector.h>

#include <array>
#include <optional>
#include <vector>

namespace insonate {

/// Pose of a body in the camera frame, as measured in one image.
struct BodyPose {
  Transform cameraFromBody;
  /// Covariance of position (mm) and rotation (rad about the camera frame's axes, through the body's origin): 6x6, row
  /// by row, x, y, z of the position first.
  std::array<double, 36> covariance{};
  double error_px = 0;         ///< root mean square distance between detected and projected corners of the tags used
  int tags = 0;                ///< number of tags used
  std::vector<int> wrongTags;  ///< ids of tags that were found but do not fit to the others
  bool isAmbiguous = false;    ///< true: only one tag was seen, and a second pose explains it nearly as well
};

/// Computes the pose of a body from the corners of all its tags together: minimizes the reprojection error by
/// Levenberg-Marquardt. Detections with an id that the body does not have are ignored. A tag that contradicts the
/// majority is left out. The two poses that fit to a single small tag are both tried; `expected`, if given, decides
/// between poses that fit about equally well. Returns no value if no tag of the body was found, or if none fits.
std::optional<BodyPose> estimatePose(const TagBody& body, const LensModel& lens,
                                     const std::vector<TagDetection>& detections,
                                     const std::optional<Transform>& expected = std::nullopt);

}  // namespace insonate
