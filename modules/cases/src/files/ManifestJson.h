#pragma once

#include <insonate/cases/PatientCase.h>

#include <string>
#include <vector>

namespace insonate {

std::string manifestToJson(const CaseManifest& manifest);

/// Fails on text that is no JSON, a missing or newer schema version, or a field of the wrong kind. Unknown fields and
/// poses that had to be straightened are noted.
Result<CaseManifest> manifestFromJson(const std::string& text, std::vector<std::string>& notes);

}  // namespace insonate
