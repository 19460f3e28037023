#pragma once

#include <insonate/cases/PatientCase.h>

#include <string>
#include <vector>

namespace insonate {

std::string manifestToJson(const CaseManifest& manifest);

/// Reads a manifest from JSON. Fails on invalid JSON, a missing or newer schema version, or a field of the wrong type.
/// Adds notes on unknown fields and on poses whose directions had to be corrected.
Result<CaseManifest> manifestFromJson(const std::string& text, std::vector<std::string>& notes);

}  // namespace insonate
