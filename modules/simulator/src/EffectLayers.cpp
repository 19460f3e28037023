#include <insonate/simulator/EffectLayers.h>

namespace insonate {
namespace {

constexpr Effects with(std::initializer_list<bool Effects::*> parts) {
  Effects effects = Effects::none();
  for (const auto part : parts) effects.*part = true;
  return effects;
}

struct Named {
  const char* name;
  Effects effects;
};

using E = Effects;

constexpr Named kCoherent[]{
    {"echogenicity", with({&E::scattering})},
    {"reflection", with({&E::reflection})},
    {"attenuation", with({&E::scattering, &E::attenuation})},
    {"transmission", with({&E::scattering, &E::transmission})},
    {"speckle", with({&E::scattering, &E::speckle})},
    {"beam", with({&E::scattering, &E::speckle, &E::beam})},
    {"layers", with({&E::scattering, &E::layers})},
    {"texture", with({&E::scattering, &E::texture})},
    {"reverberation", with({&E::scattering, &E::reflection, &E::transmission, &E::reverberation})},
    {"edge_shadow", with({&E::scattering, &E::attenuation, &E::edgeShadow})},
    {"clutter", with({&E::scattering, &E::clutter})},
    {"noise", with({&E::scattering, &E::attenuation, &E::noise})},
    {"near_field", with({&E::scattering, &E::nearField})},
};

constexpr Named kThesis[]{
    {"reflection", with({&E::reflection, &E::texture})},
    {"absorption", with({&E::scattering, &E::attenuation, &E::transmission})},
    {"blur", with({&E::reflection, &E::texture, &E::beam})},
    {"speckle", with({&E::scattering, &E::speckle})},
};

}  // namespace

std::vector<EffectLayer> effectLayers(const ImagingSettings& settings) {
  std::vector<EffectLayer> layers;
  const auto add = [&](const Named& named) {
    layers.push_back({named.name, settings});
    layers.back().settings.effects = named.effects;
  };
  if (settings.look == Look::Thesis)
    for (const Named& named : kThesis) add(named);
  else
    for (const Named& named : kCoherent) add(named);
  return layers;
}

}  // namespace insonate
