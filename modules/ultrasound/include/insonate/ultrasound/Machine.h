#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A class of ultrasound machines: the settings with which it makes its images, each with its source.
struct Machine {
  std::string name;   ///< "cart-2024"
  std::string title;  ///< "cart, 2024", for a list
  std::string about;  ///< one sentence
};

/// The presets of resources/machines, in a fixed order.
const std::vector<Machine>& machines();

/// Overrides the settings that the machine of this name decides for a probe of this shape, its frequency held within
/// the probe's; depth, focus, TGC and effects stay as they are. Fails on an unknown name and lists the known ones.
Result<ImagingSettings> settingsOf(std::string_view machine, const Probe& probe, ImagingSettings base);

/// Machine whose settings equal these in everything that it sets; null without one.
const Machine* machineOf(const ImagingSettings& settings, const Probe& probe);

}  // namespace insonate
