#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

inline constexpr const char* kCtFile = "ct.nrrd";
inline constexpr const char* kLabelFile = "labels.seg.nrrd";
inline constexpr const char* kPlainLabelFile = "labels.nrrd";
inline constexpr const char* kManifestFile = "case.json";
inline constexpr const char* kSnapFile = "labels.label.txt";

/// A missing file is an empty manifest and a note.
Result<CaseManifest> readManifest(const std::filesystem::path& file, std::vector<std::string>& notes);

/// Fails on volumes that cannot be written as a case.
Result<void> checkVolumes(const PatientCase& patient);

/// Writes a case into a new folder, with this manifest. `sameCt`: a file with the identical CT, linked if the file
/// system can; empty for none.
Result<void> writeCaseFiles(const PatientCase& patient, const CaseManifest& manifest,
                            const std::filesystem::path& folder, const std::filesystem::path& sameCt,
                            const Progress& progress);

}  // namespace insonate
