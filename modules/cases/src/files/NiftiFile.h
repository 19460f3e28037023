#pragma once

#include "VolumeFile.h"

namespace insonate {

/// Reads NIfTI-1 or NIfTI-2, compressed or not, in either byte order. By itself: ITK 5.2 knows no NIfTI-2, refuses
/// oblique grids whose directions are rounded to floats, and fills missing voxels with zeros. Where sform and qform
/// differ, the sform counts if it leads to the scanner's frame, else the qform, as 3D Slicer has it. Fails as
/// readVolumeFile does.
Result<RawVolume> readNifti(const std::filesystem::path& file, ReadPart part);

}  // namespace insonate
