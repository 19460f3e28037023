#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A class of ultrasound machines. The preset of a class (resources/machines) contains the settings that reproduce
/// images of such machines, each with its source.
struct Machine {
  std::string name;   ///< identifier, e.g. "cart-2024"
  std::string title;  ///< title for a list, e.g. "cart, 2024"
  std::string about;  ///< description of the machine in one sentence
};

/// Returns the classes of machines with a preset in resources/machines, in a fixed order.
const std::vector<Machine>& machines();

/// Returns `base` with those settings replaced that the preset of a machine determines for a probe of this shape; the
/// frequency is limited to the range of the probe. Depth, focus, TGC and effects are not changed. Fails on an unknown
/// name with a sentence that lists the known names.
Result<ImagingSettings> settingsOf(std::string_view machine, const Probe& probe, ImagingSettings base);

/// Returns the machine whose preset agrees with these settings; null if there is none.
const Machine* machineOf(const ImagingSettings& settings, const Probe& probe);

}  // namespace insonate
