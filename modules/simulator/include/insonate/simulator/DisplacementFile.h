#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

#include <filesystem>

namespace insonate {

/// The displacement as a vector volume of one slice, NRRD, which 3D Slicer and ITK read: float32, three components,
/// columns (lateral) by rows (axial) by 1, placed in patient LPS by the pose. A vector is in patient LPS, mm: from
/// where tissue is seen to where it lay at rest, the direction in which resampling needs it. Written atomically; fails
/// with a sentence, on an empty displacement, too.
Result<void> writeDisplacement(const PlaneDisplacement& displacement, const Transform& patientFromProbe,
                               const std::filesystem::path& file);

}  // namespace insonate
