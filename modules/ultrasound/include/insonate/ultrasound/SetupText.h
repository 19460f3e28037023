#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace insonate {

/// The shape's name in a probe file: "linear".
std::string_view nameOf(ProbeShape shape);

/// Text form of a probe, as saveProbe() writes and loadProbe() reads it; exact to the last bit.
std::string textOf(const Probe& probe);
Result<Probe> parseProbe(std::string_view json);

/// All fields, as settingsFromJson() reads them back to the last bit.
nlohmann::json jsonOf(const ImagingSettings& settings);

}  // namespace insonate
