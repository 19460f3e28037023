#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptHeader.h>

#include <filesystem>
#include <vector>

namespace insonate {

/// Finds the case on which an attempt was made: a version of a case in one of the folders of case folders (`libraries`;
/// empty paths are skipped), or a built-in case, which takes some seconds to build. Fails if none has the recorded
/// fingerprint of the voxels.
Result<PatientCase> caseOfAttempt(const AttemptHeader& header, const std::vector<std::filesystem::path>& libraries,
                                  const Progress& progress = {});

}  // namespace insonate
