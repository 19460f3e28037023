#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

#include <filesystem>

namespace insonate {

/// Writes the tissue displacement in the image plane as an NRRD vector volume of one slice, which 3D Slicer and ITK
/// read: float32, three components, columns (lateral) by rows (axial) by 1, placed in patient LPS by
/// `patientFromProbe`. Each vector (patient LPS, mm) points from the present position of the tissue to its undeformed
/// position, as resampling needs. The file is written atomically. Fails with a sentence if the displacement is empty or
/// the file cannot be written.
Result<void> writeDisplacement(const PlaneDisplacement& displacement, const Transform& patientFromProbe,
                               const std::filesystem::path& file);

}  // namespace insonate
