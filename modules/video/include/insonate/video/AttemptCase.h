#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptHeader.h>

#include <filesystem>

namespace insonate {

/// Finds the case on which an attempt was made: a version of a case in a folder of case folders (`cases`; empty: none),
/// or a built-in neck, which takes some seconds to build. Fails if neither has the recorded fingerprint of the voxels.
Result<PatientCase> caseOfAttempt(const AttemptHeader& header, const std::filesystem::path& cases,
                                  const Progress& progress = {});

}  // namespace insonate
