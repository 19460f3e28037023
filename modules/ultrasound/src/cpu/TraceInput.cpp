#include "cpu/TraceInput.h"

#include "model/Boundary.h"

#include <cmath>

namespace insonate::cpu {
namespace {

/// Share of the amplitude that remains after half of a loss.
float halfwayOf(double loss_dB) {
  return static_cast<float>(std::pow(10, -loss_dB / 40));
}

}  // namespace

void setChannels(const AcousticScene::Impl& scene, TraceInput& input) {
  const FramePlan& plan = *input.plan;
  const double f_MHz = plan.settings.frequency_MHz, perGate_cm = plan.gate_mm / 10;
  input.gasChannels = input.texturedChannels = 0;
  input.anyCt = false;
  for (int c = 0; c < scene.field.channels; ++c) {
    const AcousticTissue& tissue = scene.table.of(scene.field.label[c]);
    ChannelConstants& k = input.channels[c];
    k.tissue = &tissue;
    k.tile = &textureTile(tissue.texture);
    k.sheets = hasSheets(tissue.texture);
    k.halfway = halfwayOf(2 * tissue.attenuation_dBpcmMHz * std::pow(f_MHz, tissue.attenuationExponent) * perGate_cm);
    k.echo_dB = static_cast<float>(tissue.echogenicity_dB);
    k.ctEcho_dBperHU = static_cast<float>(tissue.ctEchogenicity_dBper100HU / 100);
    k.impedance = static_cast<float>(tissue.impedance_MRayl);
    k.ctImpedancePerHU = static_cast<float>(tissue.ctImpedancePer100HU / 100);
    k.textureStrength_dB = static_cast<float>(tissue.textureStrength_dB);
    if (tissue.texture != Texture::None && plan.settings.effects.texture) input.texturedChannels |= 1U << c;
    if (tissue.gas) input.gasChannels |= 1U << c;
    input.anyCt |= tissue.ctEchogenicity_dBper100HU != 0 || tissue.ctImpedancePer100HU != 0;
  }
  const double edgeLoss_dB = 2 * acoustics::kEdgeLoss_dBpcmMHz * f_MHz * perGate_cm;
  for (int a = 0; a < scene.field.channels; ++a)
    for (int b = 0; b < scene.field.channels; ++b) {
      const AcousticTissue &first = *input.channels[a].tissue, &second = *input.channels[b].tissue;
      const bool grazes = (first.vessel || second.vessel) && !acousticallyEqual(first, second);
      input.halfwayEdge[a * TissueField::kStride + b] = grazes ? halfwayOf(edgeLoss_dB) : 1.0F;
    }
}

}  // namespace insonate::cpu
