#pragma once

#include "VolumeFile.h"

namespace insonate {

/// Reads NIfTI-1 or NIfTI-2, compressed or not, in either byte order. ITK 5.2 is not used, because it does not read
/// NIfTI-2, refuses oblique grids whose directions are rounded to floats, and fills missing voxels with zeros. If sform
/// and qform differ, the sform is used if it leads to the scanner's frame, else the qform, as in 3D Slicer. Fails with
/// the errors of readVolumeFile().
Result<RawVolume> readNifti(const std::filesystem::path& file, ReadPart part);

/// Reads a file as readNifti() does, but passes the values to `sink` block by block, and returns only the header.
/// Blocks of zeros are left out. The file is decompressed only once, so that errors may be found after `sink` was
/// called.
Result<RawVolume> readNiftiBlocks(const std::filesystem::path& file, const ValueSink& sink);

}  // namespace insonate
