#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Reads a folder's case.json without its volumes; returns an empty manifest if the folder has none. Fails like
/// readCase().
Result<CaseManifest> readManifestOf(const std::filesystem::path& folder);

/// Identifies the state of a case on disk without reading volumes: a Fingerprint of case.json and of the sizes and
/// times of the volumes. Results computed from a case may be cached under it.
std::string diskStateOf(const std::filesystem::path& folder);

}  // namespace insonate
