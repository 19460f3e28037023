#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Transform.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Returns the transform patientFromProbe of a probe whose face is centered at `position_mm` (patient LPS): z is along
/// `axial`, x along the component of `lateral` perpendicular to `axial`, and y = axial x lateral (elevation).
/// Directions may have any length. Fails on values that are not finite, zero directions, and directions within 1 degree
/// of parallel.
Result<Transform> patientFromProbe(Vec3 position_mm, Vec3 axial, Vec3 lateral);

/// Converts a transform to position, axial and lateral directions, for display and storage; inverse of
/// patientFromProbe().
StartPose toStartPose(const Transform& patientFromProbe);

/// One pose of a probe, or a path of poses.
struct PosePath {
  std::vector<Transform> patientFromProbe;  ///< poses, at least one
  bool isPath = false;                      ///< true: the poses were given as a list, which may contain a single pose
  /// Sentences about directions that were not perpendicular and were corrected, and about poses that were found
  /// automatically.
  std::vector<std::string> warnings;
};

/// Reads poses from text that the user entered: "auto" (see autoStartPose), the name of one of the case's start poses,
/// inline JSON, or a JSON file. JSON is {"position_mm": [x, y, z], "axial": [x, y, z], "lateral": [x, y, z]} in patient
/// LPS, a list of such objects, or {"poses": [...]}. Fails with a sentence that names the pose and the field.
Result<PosePath> readPoses(std::string_view text, const PatientCase& patient);

}  // namespace insonate
