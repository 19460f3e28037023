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

/// Reads case.json; a missing file gives an empty manifest and a note.
Result<CaseManifest> readManifest(const std::filesystem::path& file, std::vector<std::string>& notes);

/// Fails on volumes that cannot be written as a case.
Result<void> checkVolumes(const PatientCase& patient);

/// Writes a case with this manifest into a new folder. `sameCt` is a file with the identical CT, which is linked
/// instead of written if the file system supports links; empty for none.
Result<void> writeCaseFiles(const PatientCase& patient, const CaseManifest& manifest,
                            const std::filesystem::path& folder, const std::filesystem::path& sameCt,
                            const Progress& progress);

}  // namespace insonate
