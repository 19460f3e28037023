#include "thesis/ThesisModel.h"

#include "scene/FieldSampling.h"

#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::thesis {
namespace {

constexpr double kGreatestSlope = fadeSlope(0.5);
// Integral of (fadeSlope / kGreatestSlope)^2 from 0 to 1: the loss at a weak interface.
constexpr double kLossShare = 256.0 / 630;

double fromDecibel(double dB) {
  return std::pow(10.0, dB / 20);
}

/// Weighted sum of a constant over structures, and its change along the beam.
struct Blend {
  double value = 0, slope = 0;
  void add(double weight, double weightSlope, double constant) {
    value += weight * constant;
    slope += weightSlope * constant;
  }
};

struct Medium {
  Blend weight, lnImpedance, lnImpedancePerHU;
  double loss_dBpmm = 0, echo_dB = 0, echo_dBperHU = 0;
};

/// The two nearest structures.
struct Nearest {
  double first = 1e3, second = 1e3;
  double firstSlope = 0, secondSlope = 0;
};

Nearest nearestOf(const SceneSample& here, const SceneSample& slope, int channels, int without) {
  Nearest n;
  for (int c = 0; c < channels; ++c) {
    if (c == without) continue;
    const double d = here.distance_mm[c];
    if (d < n.first) {
      n.second = n.first, n.secondSlope = n.firstSlope;
      n.first = d, n.firstSlope = slope.distance_mm[c];
    } else if (d < n.second) {
      n.second = d, n.secondSlope = slope.distance_mm[c];
    }
  }
  return n;
}

/// The weight of a structure depends on how far its distance is below the mean of the two smallest distances.
Medium mediumOf(const SceneSample& here, const SceneSample& slope, int without, double interface_mm, int channels,
                const std::array<ChannelAcoustics, TissueField::kStride>& acoustics) {
  const Nearest n = nearestOf(here, slope, channels, without);
  const double middle = (n.first + n.second) / 2, middleSlope = (n.firstSlope + n.secondSlope) / 2;
  Medium m;
  for (int c = 0; c < channels; ++c) {
    if (c == without) continue;
    const double t = std::clamp(0.5 - (here.distance_mm[c] - middle) / interface_mm, 0.0, 1.0);
    const double w = fade(t);
    const double ws = -fadeSlope(t) * (slope.distance_mm[c] - middleSlope) / interface_mm;
    m.weight.add(w, ws, 1);
    m.lnImpedance.add(w, ws, acoustics[c].lnImpedance);
    m.lnImpedancePerHU.add(w, ws, acoustics[c].lnImpedancePerHU);
    m.loss_dBpmm += w * acoustics[c].loss_dBpmm;
    m.echo_dB += w * acoustics[c].echo_dB;
    m.echo_dBperHU += w * acoustics[c].echo_dBperHU;
  }
  return m;
}

/// Change along the beam of a blend divided by the sum of the weights.
double slopeOf(const Blend& blend, const Blend& weight) {
  return (blend.slope - blend.value / weight.value * weight.slope) / weight.value;
}

}  // namespace

ThesisPlan::ThesisPlan(const FramePlan& plan)
    : mapRows(2 * plan.nodeRows - 1),
      row_mm(plan.cellGates * plan.gate_mm),
      interface_mm(std::max(kInterface_mm, 4 * mapRow_mm())),
      steepness_mm(interface_mm / kGreatestSlope),
      lossLength_mm(interface_mm * kLossShare) {
  const double pulse_mm = axialFwhm_mm(plan.probe, plan.settings);
  const double focus_mm = std::min(plan.settings.focus_mm, plan.settings.depth_mm);
  const double width_mm = plan.lines * plan.grid.scanlineSpacing_mm(focus_mm);
  noise = {width_mm / (kNoiseCellLateral * lateralFwhm_mm(plan.probe, plan.settings, focus_mm)),
           plan.settings.depth_mm / (kNoiseCellAxial * pulse_mm)};
  tailShare = plan.settings.effects.beam ? std::exp(-plan.gate_mm / (kTail * pulse_mm)) : 0;
}

std::array<ChannelAcoustics, TissueField::kStride> channelAcoustics(const ImagingSettings& settings,
                                                                    const AcousticScene::Impl& scene) {
  std::array<ChannelAcoustics, TissueField::kStride> channels;
  for (int c = 0; c < scene.field.channels; ++c) {
    const AcousticTissue& tissue = scene.table.of(scene.field.label[c]);
    ChannelAcoustics& channel = channels[c];
    channel.lnImpedance = std::log(tissue.impedance_MRayl);
    channel.echo_dB = tissue.echogenicity_dB;
    if (settings.effects.attenuation)
      channel.loss_dBpmm =
          2 * tissue.attenuation_dBpcmMHz * std::pow(settings.frequency_MHz, tissue.attenuationExponent) / 10;
    if (settings.effects.texture) {
      channel.lnImpedancePerHU = tissue.ctImpedancePer100HU / 100;
      channel.echo_dBperHU = tissue.ctEchogenicity_dBper100HU / 100;
    }
  }
  return channels;
}

double beyondLattice(const TissueField& field, Vec3 node) {
  double beyond = 0;
  for (int a = 0; a < 3; ++a) beyond = std::max({beyond, -0.5 - node[a], node[a] - (field.size[a] - 0.5)});
  return std::min(1.0, 2 * beyond);
}

SceneSample sampleScene(const TissueField& field, Vec3 patient_mm) {
  const Vec3 node = field.nodeFromPatient * patient_mm;
  const FieldCell at = cellAt(field, node);
  SceneSample sample;
  sample.beyond = beyondLattice(field, node);
  for (int corner = 0; corner < 8; ++corner) {
    for (int c = 0; c < field.channels; ++c)
      sample.distance_mm[c] += at.weight[corner] * field.distance[at.offset[corner]].to[c] / TissueField::kUnitsPerMm;
    sample.ctDeviation_HU += at.weight[corner] * field.ctDeviation[at.offset[corner]];
  }
  return sample;
}

double reflectionOf(double lnImpedanceSlope_pmm, const ThesisPlan& plan) {
  return std::tanh(plan.steepness_mm * std::abs(lnImpedanceSlope_pmm) / 2);
}

double reflectionLoss_dBpmm(double lnImpedanceSlope_pmm, const ThesisPlan& plan) {
  // 1 - R^2 = 1 / cosh^2(artanh R).
  const double artanh = plan.steepness_mm * std::abs(lnImpedanceSlope_pmm) / 2;
  const double lnCosh = artanh + std::log1p(std::exp(-2 * artanh)) - std::numbers::ln2;
  return 40 / std::numbers::ln10 * lnCosh / plan.lossLength_mm;
}

MapSample mapAt(const SceneSample& here, const SceneSample& slope, double range_mm, const ThesisPlan& plan,
                const ImagingSettings& settings, const AcousticScene::Impl& scene,
                const std::array<ChannelAcoustics, TissueField::kStride>& channels) {
  // Gel matches the tissue behind it and neither scatters nor absorbs.
  const int gel = mayBeGel(range_mm) ? scene.field.backgroundChannel : -1;
  const double tissue = gel < 0 ? 1 : fade(std::clamp(0.5 + here.distance_mm[gel] / plan.interface_mm, 0.0, 1.0));
  const bool onlyGel = gel >= 0 && scene.field.channels == 1;
  const Medium m = mediumOf(here, slope, onlyGel ? -1 : gel, plan.interface_mm, scene.field.channels, channels);
  const double lnImpedanceSlope = slopeOf(m.lnImpedance, m.weight) +
                                  slopeOf(m.lnImpedancePerHU, m.weight) * here.ctDeviation_HU +
                                  m.lnImpedancePerHU.value / m.weight.value * slope.ctDeviation_HU;
  const double within = 1 - here.beyond;
  MapSample map;
  if (settings.effects.reflection)
    map.reflection = within * tissue * fromDecibel(kReflectorGain_dB) * reflectionOf(lnImpedanceSlope, plan);
  map.loss_dBpmm = tissue * m.loss_dBpmm / m.weight.value + kBeyondLoss_dBpmm * here.beyond;
  if (settings.effects.transmission) map.loss_dBpmm += tissue * reflectionLoss_dBpmm(lnImpedanceSlope, plan);
  if (settings.effects.scattering)
    map.echo = within * tissue * fromDecibel((m.echo_dB + m.echo_dBperHU * here.ctDeviation_HU) / m.weight.value);
  return map;
}

double speckleFactor(double noise) {
  return std::max(0.0, 1 + kSpeckleContrast * noise) / std::sqrt(1 + kSpeckleContrast * kSpeckleContrast);
}

}  // namespace insonate::thesis
