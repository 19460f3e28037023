#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate::preparation {

/// An image of a report.
struct ReportImage {
  std::string file;     ///< name of the PNG file
  std::string caption;  ///< what the image shows, one line
};

/// Writes three axial slices and one coronal slice with the outlines of the structures. The middle axial slice goes
/// through the first target; without a target, through the middle of the volume.
Result<std::vector<ReportImage>> writeSlices(const CaseView& patient, const std::filesystem::path& folder);

/// Writes the patient from the front: bone, vessels and airway through a translucent skin.
Result<ReportImage> writeFront(const CaseView& patient, const std::filesystem::path& folder);

/// Writes ultrasound images at the first start poses of the case; without start poses, at the pose that is found
/// automatically.
Result<std::vector<ReportImage>> writeUltrasound(const PatientCase& patient, const std::filesystem::path& folder,
                                                 const Progress& progress);

}  // namespace insonate::preparation
