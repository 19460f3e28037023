#pragma once

#include "../masks/LabelAssembly.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <filesystem>

namespace insonate {

/// Tells whether a file states that it is a DICOM RT Structure Set.
bool isStructureSet(const std::filesystem::path& file);

/// Adds the structures of an RT Structure Set. A voxel belongs to a structure if its center lies in an odd number of
/// the contours of its slice. Between contoured slices at most 10 mm apart, up to three slices without contours get an
/// interpolated shape, with a note. Contours that are not parallel to the slices of the CT are resampled. The outline
/// of the body and the volumes of a radiotherapy plan are left out unless the author has chosen them. Structures
/// without closed contours, or whose contours do not lie in parallel planes, are listed without voxels and with a note.
/// Fails if the file or a structure to read is damaged, or if no structure to read lies in the CT.
Result<void> addStructureSet(const PatientCase& patient, const std::filesystem::path& file, LabelAssembly& assembly,
                             const Progress& progress);

}  // namespace insonate
