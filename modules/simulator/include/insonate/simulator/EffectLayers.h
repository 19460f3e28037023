#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <vector>

namespace insonate {

/// Imaging settings with which the image shows a single physical effect (attenuation, beam width, clutter, ...).
struct EffectLayer {
  std::string name;  ///< name of the effect; valid as a file name
  ImagingSettings settings;
};

/// Returns one layer for each effect of the rendering style of these settings. An effect that changes echoes
/// (attenuation, beam, clutter, ...) is shown with uniform scattering as the source of echoes.
std::vector<EffectLayer> effectLayers(const ImagingSettings& settings);

}  // namespace insonate
