#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A class of ultrasound machines: the settings that reproduce its images, each with its source.
struct Machine {
  std::string name;   ///< identifier, e.g. "cart-2024"
  std::string title;  ///< title for a list, e.g. "cart, 2024"
  std::string about;  ///< description of the machine in one sentence
};

/// Returns the presets of resources/machines, in a fixed order.
const std::vector<Machine>& machines();

/// Replaces the settings that this machine determines for a probe of this shape; the frequency is limited to the
/// probe's range. Depth, focus, TGC and effects are kept. Fails on an unknown name, and lists the known names.
Result<ImagingSettings> settingsOf(std::string_view machine, const Probe& probe, ImagingSettings base);

/// Returns the machine whose settings all equal these; null if there is none.
const Machine* machineOf(const ImagingSettings& settings, const Probe& probe);

}  // namespace insonate
