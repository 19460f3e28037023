#pragma once

#include "VolumeFile.h"

namespace insonate {

/// Reads the header of NIfTI-1 or NIfTI-2, compressed or not, in either byte order. ITK 5.2 is not used, because it
/// does not read NIfTI-2, refuses oblique grids whose directions are rounded to floats, and fills missing voxels with
/// zeros. If sform and qform differ, the sform is used if it leads to the scanner's frame, else the qform, as in 3D
/// Slicer. Fails with the errors of readVolumeHeader().
Result<VolumeHeader> readNiftiHeader(const std::filesystem::path& file);

/// Reads a file as readVolumeBlocks() does. Blocks of zeros are left out. The file is decompressed only once, so that
/// errors may be found after `sink` was called.
Result<VolumeHeader> readNiftiBlocks(const std::filesystem::path& file, const ValueSink& sink);

}  // namespace insonate
