#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <vector>

namespace insonate {

/// Settings that show one effect of the image by itself.
struct EffectLayer {
  std::string name;  ///< suits a file name
  ImagingSettings settings;
};

/// Every effect of the settings' look alone. An effect that acts on echoes (attenuation, beam, clutter, ...) is shown
/// on plain, even scattering.
std::vector<EffectLayer> effectLayers(const ImagingSettings& settings);

}  // namespace insonate
