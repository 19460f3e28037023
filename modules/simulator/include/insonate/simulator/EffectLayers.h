#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <vector>

namespace insonate {

/// Settings that show one effect of the image by itself.
struct EffectLayer {
  std::string name;  ///< valid as a file name
  ImagingSettings settings;
};

/// Returns one layer for every effect of the settings' rendering style. An effect that acts on echoes (attenuation,
/// beam, clutter, ...) is shown on plain, even scattering.
std::vector<EffectLayer> effectLayers(const ImagingSettings& settings);

}  // namespace insonate
