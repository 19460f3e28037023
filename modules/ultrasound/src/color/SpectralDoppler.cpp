#include "color/ColorPlan.h"
#include "color/FlowSegments.h"

#include <insonate/core/JsonEntry.h>
#include <insonate/core/Range.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ultrasound/PlaneTissue.h>
#include <insonate/ultrasound/PointSpread.h>
#include <insonate/ultrasound/SpectralDoppler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

struct SpectralNumber {
  std::string_view name;
  double SpectralSettings::*member;
  double low, high;
};
constexpr SpectralNumber kSpectralNumbers[] = {
    {"across", &SpectralSettings::across, 0, 1},
    {"range_mm", &SpectralSettings::range_mm, 1, 400},
    {"gate_mm", &SpectralSettings::gate_mm, 0.5, 20},
    {"steering_deg", &SpectralSettings::steering_deg, -20, 20},
    {"frequency_MHz", &SpectralSettings::frequency_MHz, 1, 20},
    {"prf_Hz", &SpectralSettings::prf_Hz, 500, 20000},
    {"wallFilter_Hz", &SpectralSettings::wallFilter_Hz, 0, 10000},
    {"angle_deg", &SpectralSettings::angle_deg, 0, 80},
    {"gain_dB", &SpectralSettings::gain_dB, -30, 30},
    {"baseline", &SpectralSettings::baseline, -0.45, 0.45},
};

/// Number of pulses from which one spectrum is computed. A Hann window over n pulses has a main lobe with a width of
/// 1.44 PRF / n at half of its amplitude.
constexpr double kPulses = 64, kMainLobe = 1.44;
constexpr double kPulseCycles = 4, kFwhm = 2.3548200450309493;

double cosineOf(const SpectralSettings& gate) {
  return std::cos(gate.angle_deg * std::numbers::pi / 180);
}

/// Color settings with a box around the gate, from which the plan of color computes beams, wall filter and noise.
ColorSettings colorAround(const SpectralSettings& gate) {
  ColorSettings color;
  color.left = std::clamp(gate.across - 0.05, 0.0, 0.9), color.right = color.left + 0.1;
  color.near_mm = std::max(0.0, gate.range_mm - gate.gate_mm), color.far_mm = gate.range_mm + gate.gate_mm;
  color.steering_deg = gate.steering_deg, color.frequency_MHz = gate.frequency_MHz;
  color.prf_Hz = gate.prf_Hz, color.wallFilter_Hz = gate.wallFilter_Hz;
  return color;
}

/// A point of the sample volume, relative to the middle of the gate.
struct VolumePoint {
  double across_mm, along_mm, weight;
};

/// Share of a Gaussian pulse within the gate whose middle is `off_mm` away.
double gateWeight(double off_mm, double gate_mm, double sd_mm) {
  const double scale = 1 / (sd_mm * std::numbers::sqrt2);
  return 0.5 * (std::erf((off_mm + gate_mm / 2) * scale) - std::erf((off_mm - gate_mm / 2) * scale));
}

/// Smooths a spectrum circularly by the resolution of its window.
void smoothCircularly(std::vector<double>& power) {
  constexpr double kSd_bins = std::max(kMainLobe / kPulses * kSpectrumBins / kFwhm, 0.3);
  constexpr int kReach = std::min(static_cast<int>(3 * kSd_bins) + 1, kSpectrumBins / 2 - 1);
  std::array<double, kReach + 1> kernel{};
  double sum = 0;
  for (int o = 0; o <= kReach; ++o) {
    kernel[o] = std::exp(-0.5 * o * o / (kSd_bins * kSd_bins));
    sum += o ? 2 * kernel[o] : kernel[o];
  }
  std::array<double, kSpectrumBins> sharp{};
  std::ranges::copy(power, sharp.begin());
  std::ranges::fill(power, 0);
  for (int bin = 0; bin < kSpectrumBins; ++bin)
    for (int o = -kReach; o <= kReach; ++o)
      power[bin] += kernel[std::abs(o)] / sum * sharp[(bin + o + kSpectrumBins) % kSpectrumBins];
}

}  // namespace

Result<SpectralSettings> spectralFromJson(const nlohmann::json& overrides, SpectralSettings gate) {
  if (!overrides.is_object()) return fail("The gate must be an object, such as {\"range_mm\": 20}.");
  std::vector<std::string_view> known;
  for (const SpectralNumber& field : kSpectralNumbers) known.push_back(field.name);
  JsonEntry entry(overrides, "The gate", known);
  for (const auto& [name, member, low, high] : kSpectralNumbers)
    gate.*member = entry.optionalNumber(name, low, high).value_or(gate.*member);
  if (!entry.error().empty()) return fail(entry.error());
  return gate;
}

nlohmann::json jsonOf(const SpectralSettings& gate) {
  nlohmann::json object = nlohmann::json::object();
  for (const SpectralNumber& field : kSpectralNumbers) object[std::string(field.name)] = gate.*field.member;
  return object;
}

Result<void> validate(const SpectralSettings& gate, const Probe& probe, const ImagingSettings& settings) {
  for (const auto& [name, member, low, high] : kSpectralNumbers)
    if (auto ok = checkRange(gate.*member, low, high, "gate: " + std::string(name)); !ok) return ok;
  const double steering_deg = probe.shape == ProbeShape::Linear ? gate.steering_deg : 0;
  const double deepest_mm = settings.depth_mm / std::cos(steering_deg * std::numbers::pi / 180);
  const double half_mm = gate.gate_mm / 2;
  if (auto ok = checkRange(gate.range_mm, half_mm, deepest_mm - half_mm, "gate: range_mm"); !ok) return ok;
  const double highest_Hz = std::floor(kSoundSpeed_mmPerUs * 1e6 / (2 * (gate.range_mm + half_mm)));
  if (auto ok = checkRange(gate.prf_Hz, 500, highest_Hz, "gate: prf_Hz"); !ok) return ok;
  return checkRange(gate.wallFilter_Hz, 0, gate.prf_Hz / 2, "gate: wallFilter_Hz");
}

double nyquistVelocity_mmps(const SpectralSettings& gate) {
  return kSoundSpeed_mmPerUs * gate.prf_Hz / (4 * gate.frequency_MHz) / cosineOf(gate);
}

double binVelocity_mmps(const SpectralSettings& gate, int bin) {
  return nyquistVelocity_mmps(gate) * (2.0 * bin / kSpectrumBins - 1);
}

SpectralSettings spectralSettingsFor(const Probe& probe, const ImagingSettings& settings) {
  const ColorSettings color = colorSettingsFor(probe, settings);
  SpectralSettings gate;
  gate.range_mm = 0.5 * settings.depth_mm;
  gate.gate_mm = std::min(gate.gate_mm, 0.2 * settings.depth_mm);
  gate.steering_deg = color.steering_deg, gate.frequency_MHz = color.frequency_MHz;
  gate.prf_Hz = std::min(gate.prf_Hz, std::floor(kSoundSpeed_mmPerUs * 1e6 / (2 * settings.depth_mm)));
  return gate;
}

GatePlace gatePlace(const Probe& probe, const ImagingSettings& settings, const SpectralSettings& gate) {
  ImagingSettings beams = settings;
  beams.steering_deg = gate.steering_deg;
  const BeamGrid grid(probe, beams);
  const double scanline = gate.across * grid.scanlines() - 0.5;
  const Vec3 face = grid.origin(scanline), beam = grid.direction(scanline);
  const auto at = [&](double range_mm) { return face + beam * range_mm; };
  return {face, at(gate.range_mm), at(gate.range_mm - gate.gate_mm / 2), at(gate.range_mm + gate.gate_mm / 2), beam};
}

/// Blood at a point of the sample volume, in a vessel of the held flow.
struct HeldBlood {
  int tube, point;   ///< indices of the vessel, and of the point of its course before this one
  float along;       ///< position between this point of the course and the next, 0 to 1
  float fromCenter;  ///< relative distance from the center line
  float cosine;      ///< of the angle between vessel and beam; positive: forward flow is away from the probe
  float echo;        ///< power of the echo
};

struct SpectralDoppler::Impl {
  Impl(const Probe& probe, const ImagingSettings& settings, const SpectralSettings& of);

  double transmission(const AcousticScene& scene, const Transform& patientFromProbe) const;
  void holdPlane(const AcousticScene& scene, Transform pose, double elevation_mm, double weight);
  void selectVessels(double elevation_mm);
  void addVelocity(double toward_mmps, double echo, std::vector<double>& power) const;

  SpectralSettings gate;
  ColorPlan plan;
  ShownTissue shown;
  double beam = 0;
  std::vector<VolumePoint> volume;
  std::vector<std::pair<double, double>> elevations;  ///< offset from the image plane, mm, and weight
  std::vector<PlanePoint> points;
  PlaneSamples tissue;
  FlowSegments segments;
  std::array<std::vector<int>, 2> near;  ///< segments near the gate: arteries, veins
  std::vector<HeldBlood> blood;
  double stillEcho = 0;  ///< power of the echoes of tissue, and of blood that does not move
};

SpectralDoppler::Impl::Impl(const Probe& probe, const ImagingSettings& settings, const SpectralSettings& of)
    : gate(of), plan(probe, settings, colorAround(of)), shown(plan) {
  constexpr double kStep_mm = 0.08, kSide_mm = 0.15, kReach_sd = 2.4;
  beam = gate.across * plan.beams.scanlines() - 0.5;
  ImagingSettings pulse = settings;
  pulse.frequency_MHz = gate.frequency_MHz, pulse.harmonic = false;
  const double toPowerSd = 1 / (kFwhm * std::numbers::sqrt2);
  const double lateralSd_mm = lateralFwhm_mm(probe, pulse, gate.range_mm) * toPowerSd;
  const double sliceSd_mm = sliceLaw(probe, gate.frequency_MHz).thickness_mm(gate.range_mm) * toPowerSd;
  const double axialSd_mm = kPulseCycles * wavelength_mm(pulse) / 2 * toPowerSd;
  const int half = static_cast<int>(std::ceil((gate.gate_mm / 2 + kReach_sd * axialSd_mm) / kStep_mm));
  const auto gaussianAt = [](int i, int count) {
    const double off_sd = kReach_sd * (2.0 * i / (count - 1) - 1);
    return std::pair(off_sd, std::exp(-0.5 * off_sd * off_sd));
  };
  // Fine enough for the smallest vessels.
  const auto countOf = [](double sd_mm) { return 2 * static_cast<int>(std::ceil(kReach_sd * sd_mm / kSide_mm)) + 1; };
  const int across = countOf(lateralSd_mm), planeCount = countOf(sliceSd_mm);
  double sum = 0;
  for (int i = 0; i < across; ++i)
    for (int k = -half; k <= half; ++k) {
      const auto [off_sd, weight] = gaussianAt(i, across);
      volume.push_back(
          {off_sd * lateralSd_mm, k * kStep_mm, weight * gateWeight(k * kStep_mm, gate.gate_mm, axialSd_mm)});
      sum += volume.back().weight;
    }
  double planes = 0;
  for (int i = 0; i < planeCount; ++i) {
    const auto [off_sd, weight] = gaussianAt(i, planeCount);
    elevations.emplace_back(off_sd * sliceSd_mm, weight);
    planes += weight;
  }
  for (VolumePoint& point : volume) point.weight /= sum * planes;
  points.resize(volume.size());
}

/// As for color (see transmittedPower()), down to the middle of the gate.
double SpectralDoppler::Impl::transmission(const AcousticScene& scene, const Transform& patientFromProbe) const {
  const int steps = static_cast<int>(gate.range_mm / ColorPlan::kTransmissionStep_mm);
  std::vector<PlanePoint> way(std::max(steps, 1));
  for (std::size_t step = 0; step < way.size(); ++step) {
    const Vec3 rest = shown.restOf(plan.point_mm(beam, ColorPlan::transmissionRange_mm(static_cast<int>(step))));
    way[step] = {static_cast<float>(rest.x), static_cast<float>(rest.z)};
  }
  PlaneSamples along;
  samplePlane(scene, patientFromProbe, way, along);
  double power = shown.contactAbove(plan.point_mm(beam, 0));
  power *= power;
  std::uint8_t before = kBackground;
  for (const std::uint8_t here : along.label) {
    if (here == kBackground) continue;
    power *= transmittedPower(scene.tissues(), plan, before == kBackground ? here : before, here,
                              ColorPlan::kTransmissionStep_mm);
    before = here;
  }
  return power;
}

/// Adds an echo to the two bins around its velocity.
void SpectralDoppler::Impl::addVelocity(double toward_mmps, double echo, std::vector<double>& power) const {
  if (!std::isfinite(toward_mmps)) return;
  const double turns = toward_mmps / (2 * plan.nyquist_mmps) + 0.5;
  const double place = (turns - std::floor(turns)) * kSpectrumBins;
  const int low = static_cast<int>(place) % kSpectrumBins;
  const double t = place - std::floor(place), passed = echo * plan.wallFilter(toward_mmps);
  power[low] += (1 - t) * passed;
  power[(low + 1) % kSpectrumBins] += t * passed;
}

SpectralDoppler::SpectralDoppler(const Probe& probe, const ImagingSettings& settings, const SpectralSettings& gate)
    : impl_(std::make_unique<Impl>(probe, settings, gate)) {}
SpectralDoppler::~SpectralDoppler() = default;
SpectralDoppler::SpectralDoppler(SpectralDoppler&&) noexcept = default;
SpectralDoppler& SpectralDoppler::operator=(SpectralDoppler&&) noexcept = default;

/// Selects the vessels that can contain a point of the plane.
void SpectralDoppler::Impl::selectVessels(double elevation_mm) {
  for (const int kind : {0, 1}) {
    near[kind].clear();
    const std::vector<float>& to_mm = kind == 0 ? tissue.toArtery_mm : tissue.toVein_mm;
    Vec3 low{HUGE_VAL, elevation_mm, HUGE_VAL}, high{-HUGE_VAL, elevation_mm, -HUGE_VAL};
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (to_mm[i] >= 0) continue;
      low.x = std::min(low.x, double(points[i].x_mm)), high.x = std::max(high.x, double(points[i].x_mm));
      low.z = std::min(low.z, double(points[i].z_mm)), high.z = std::max(high.z, double(points[i].z_mm));
    }
    if (low.x <= high.x) segments.select(kind == 0 ? kArtery : kVein, low, high, near[kind]);
  }
}

void SpectralDoppler::Impl::holdPlane(const AcousticScene& scene, Transform pose, double elevation_mm, double weight) {
  pose.offset = pose * Vec3{0, elevation_mm, 0};
  samplePlane(scene, pose, points, tissue);
  selectVessels(elevation_mm);
  const Vec3 direction = plan.beams.direction(beam);
  std::array<double, 256> echoes{};
  for (int label = 0; label < 256; ++label)
    echoes[label] = std::pow(10, scene.tissues().of(static_cast<std::uint8_t>(label)).echogenicity_dB / 10);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    const bool artery = tissue.toArtery_mm[i] < 0, vein = !artery && tissue.toVein_mm[i] < 0;
    std::uint8_t label = tissue.label[i];
    if (artery || vein) label = artery ? kArtery : kVein;
    const double echo = weight * volume[i].weight * echoes[label];
    FlowPlace place;
    if (artery || vein)
      place = segments.find(near[artery ? 0 : 1], points[i].x_mm, static_cast<float>(elevation_mm), points[i].z_mm);
    if (place.segment < 0) {
      stillEcho += echo;
      continue;
    }
    const FlowSegment& s = segments.segment(place.segment);
    const float depth_mm = -(artery ? tissue.toArtery_mm : tissue.toVein_mm)[i];
    blood.push_back({s.tube, s.point, place.along, place.off_mm / (place.off_mm + depth_mm),
                     static_cast<float>(dot(s.direction, direction) + place.along * dot(s.directionChange, direction)),
                     static_cast<float>(echo)});
  }
}

void SpectralDoppler::hold(const AcousticScene& scene, const Transform& patientFromProbe,
                           const PlaneDisplacement& displacement, const BloodFlow& flow) {
  Impl& impl = *impl_;
  impl.shown.update(impl.plan, scene.impl().field, patientFromProbe, displacement);
  impl.blood.clear();
  impl.stillEcho = 0;
  const Vec3 direction = impl.plan.beams.direction(impl.beam), side{direction.z, 0, -direction.x};
  const Vec3 middle = impl.plan.point_mm(impl.beam, impl.gate.range_mm);
  for (std::size_t i = 0; i < impl.volume.size(); ++i) {
    const Vec3 rest = impl.shown.restOf(middle + side * impl.volume[i].across_mm + direction * impl.volume[i].along_mm);
    impl.points[i] = {static_cast<float>(rest.x), static_cast<float>(rest.z)};
  }
  const double reach_mm = std::abs(impl.elevations.front().first);
  impl.segments.update(flow, patientFromProbe, reach_mm);
  // All bins together have the noise of the whole band.
  const double scale = impl.transmission(scene, patientFromProbe) * kSpectrumBins / impl.plan.noisePower;
  for (const auto& [elevation_mm, weight] : impl.elevations)
    impl.holdPlane(scene, patientFromProbe, elevation_mm, scale * weight);
}

void SpectralDoppler::spectrum(const BloodFlow& flow, Vec3 tissue_mmps, std::vector<double>& power) {
  const Impl& impl = *impl_;
  power.assign(kSpectrumBins, 0);
  const double still_mmps = -dot(tissue_mmps, impl.plan.beams.direction(impl.beam));
  impl.addVelocity(still_mmps, impl.stillEcho, power);
  for (const HeldBlood& held : impl.blood) {
    const BloodTube& tube = flow.tubes[held.tube];
    const double before = tube.course[held.point].scale,
                 after = tube.course[std::min<std::size_t>(held.point + 1, tube.course.size() - 1)].scale;
    const double speed_mmps = (before + held.along * (after - before)) * tube.profileAt_mmps(held.fromCenter);
    impl.addVelocity(still_mmps - speed_mmps * held.cosine, held.echo, power);
  }
  smoothCircularly(power);
}

}  // namespace insonate
