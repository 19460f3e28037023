#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

#include <filesystem>

namespace insonate {

/// Writes the displacement as a vector volume of one slice, NRRD, which 3D Slicer and ITK read: float32, three
/// components, columns (lateral) by rows (axial) by 1, placed in patient LPS by the pose. A vector is in patient LPS,
/// mm. It points from the present place of the tissue to its place at rest, which is the direction that resampling
/// needs. Written atomically. Fails with a sentence, also if the displacement is empty.
Result<void> writeDisplacement(const PlaneDisplacement& displacement, const Transform& patientFromProbe,
                               const std::filesystem::path& file);

}  // namespace insonate
