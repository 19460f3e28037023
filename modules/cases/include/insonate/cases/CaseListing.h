#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Returns the names of the files that a case can have in its folder: "ct.nrrd", "labels.seg.nrrd" ...
const std::vector<std::string>& caseFileNames();

/// Reads the case.json of a case folder, without the volumes. Returns a default manifest if the folder has no
/// case.json. Fails as readCase() does.
Result<CaseManifest> readCaseManifest(const std::filesystem::path& folder);

/// Returns a fingerprint of the files of a case, computed from the contents of case.json and from the sizes and times
/// of the volume files, which are not read. Use the fingerprint as the key of cached results that were computed from
/// the case.
std::string diskFingerprint(const std::filesystem::path& folder);

}  // namespace insonate
