#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace insonate {

/// What saveProbe() writes, and what loadProbe() reads, as text: back to the last bit.
std::string textOf(const Probe& probe);
Result<Probe> parseProbe(std::string_view json);

/// All fields, as settingsFromJson() reads them back to the last bit.
nlohmann::json jsonOf(const ImagingSettings& settings);

}  // namespace insonate
