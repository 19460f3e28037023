#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <vector>

namespace insonate {

/// Imaging settings with which the image shows one physical effect (attenuation, beam width, clutter, ...) alone.
struct EffectLayer {
  std::string name;  ///< name of the effect; valid as a file name
  ImagingSettings settings;
};

/// Returns one layer for every effect that these settings' rendering style uses. An effect that acts on echoes
/// (attenuation, beam, clutter, ...) is shown on uniform scattering.
std::vector<EffectLayer> effectLayers(const ImagingSettings& settings);

}  // namespace insonate
