#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace insonate {

/// Returns the name of a probe's shape in a probe file, e.g. "linear".
std::string_view nameOf(ProbeShape shape);

/// Writes a probe as text in the format of probe files. parseProbe() reads exactly the same values from the text.
std::string textOf(const Probe& probe);
Result<Probe> parseProbe(std::string_view json);

/// Writes all fields as JSON, which settingsFromJson() reads back exactly.
nlohmann::json jsonOf(const ImagingSettings& settings);

}  // namespace insonate
