#pragma once

#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <filesystem>

namespace insonate {

/// Returns the DICOM header entries of a case. The entries depend only on the CT's voxels and grid. An image series and
/// a segmentation of the same CT therefore refer to each other even if they are written at different times.
DicomSeriesIdentity dicomIdentityOf(const PatientCase& patient);

/// Writes the labels as a DICOM segmentation (PS3.3 A.51) with SNOMED CT codes and the case's colors: binary, one
/// segment per label, without empty frames. The segmentation refers to the slices that writeDicomSeries() writes for
/// the same CT with dicomIdentityOf(). On any failure an existing file is unchanged. Fails if nothing is labeled, or if
/// the file cannot be written.
Result<void> writeDicomSegmentation(const PatientCase& patient, const std::filesystem::path& file,
                                    const Progress& progress = {});

}  // namespace insonate
