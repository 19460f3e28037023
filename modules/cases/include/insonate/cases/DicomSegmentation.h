#pragma once

#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <filesystem>

namespace insonate {

/// Identity of a case in DICOM. It depends on the CT's voxels and grid alone, so that series and segmentation belong
/// together whenever each of them was written.
DicomSeriesIdentity dicomIdentityOf(const PatientCase& patient);

/// Writes the labels as a DICOM segmentation (PS3.3 A.51; binary, one segment a label, frames without a voxel left
/// out) with SNOMED CT codes and the case's colors. It refers to the slices that writeDicomSeries makes of the same CT
/// under dicomIdentityOf. On any failure an existing file is untouched. Fails if nothing is labeled, or if the file
/// cannot be written.
Result<void> writeDicomSegmentation(const PatientCase& patient, const std::filesystem::path& file,
                                    const Progress& progress = {});

}  // namespace insonate
