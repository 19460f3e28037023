#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Reads a folder's case.json without the volumes; returns an empty manifest if the folder has no case.json. Fails with
/// the errors of readCase().
Result<CaseManifest> readManifestOf(const std::filesystem::path& folder);

/// Returns a Fingerprint of a case on disk: of case.json and of the sizes and times of the volume files, which are not
/// read. The text can be the key under which results computed from the case are cached.
std::string diskStateOf(const std::filesystem::path& folder);

}  // namespace insonate
