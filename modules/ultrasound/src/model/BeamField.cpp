#include "model/BeamField.h"

#include <insonate/ultrasound/PointSpread.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

namespace insonate {
namespace {

constexpr int kNodes = 40;
constexpr int kFrequencies = 7;
constexpr int kLateralEntries = 96, kElevationEntries = 160;
constexpr double kLateralStep = 0.2;  // relative to wavelength times F-number
constexpr double kElevationStep = 1.0 / 80, kPiecesPerWavelength = 2.5;
// Tapered shares of the transmit aperture, and of the element's height, whose ends are fixed.
constexpr double kTransmitTaper = 0.5, kHeightTaper = 0.15;

using Spectrum = std::array<std::complex<double>, kFrequencies>;

/// Frequencies over the band of the pulse: equally spaced, up to a loss of 24 dB of the Gaussian spectrum.
struct Band {
  double first_radpmm, step_radpmm;  ///< wave numbers
  std::array<double, kFrequencies> power;

  Band(double frequency_MHz, double bandwidth_MHz) {
    constexpr double kReach = 1;  // range as a share of the bandwidth, to either side
    const double wavesPerMHz = 2 * std::numbers::pi / kSoundSpeed_mmPerUs;
    const double reach_MHz = std::min(kReach * bandwidth_MHz, 0.9 * frequency_MHz);
    first_radpmm = wavesPerMHz * (frequency_MHz - reach_MHz);
    step_radpmm = wavesPerMHz * 2 * reach_MHz / (kFrequencies - 1);
    for (int f = 0; f < kFrequencies; ++f) {
      const double off = reach_MHz * (2.0 * f / (kFrequencies - 1) - 1) / bandwidth_MHz;
      power[f] = std::exp(-8 * std::numbers::ln2 * off * off);
    }
  }
};

/// Origin of a wave, in the plane of the field.
struct Source {
  double at_mm, delay_mm, weight;
};

/// `size_mm`: size of a source along the aperture, for its directivity; 0 for a point.
Spectrum fieldAt(std::span<const Source> sources, double size_mm, const Band& band, double off_mm, double range_mm) {
  Spectrum sum{};
  for (const Source& source : sources) {
    const double r_mm = std::hypot(off_mm - source.at_mm, range_mm), path_mm = r_mm - source.delay_mm;
    const double half = size_mm / 2 * (off_mm - source.at_mm) / r_mm;  // phase over half of it, per wave number
    const double centre_radpmm = band.first_radpmm + band.step_radpmm * (kFrequencies - 1) / 2;
    const double phase = half * centre_radpmm;
    const double directivity = std::abs(phase) > 1e-6 ? std::sin(phase) / phase : 1;
    std::complex<double> wave = std::polar(source.weight * directivity / std::sqrt(r_mm), band.first_radpmm * path_mm);
    const std::complex<double> turn = std::polar(1.0, band.step_radpmm * path_mm);
    for (std::complex<double>& at : sum) at += wave, wave *= turn;
  }
  return sum;
}

/// Amplitude there and back. A harmonic arises where the transmitted wave of half the frequency is strong, as its
/// square (quasi-linear theory: Du and Breazeale, J Acoust Soc Am 1985;78:2083; Averkiou, IEEE Ultrasonics Symp
/// 2000:1563).
double twoWay(const Spectrum& transmit, const Spectrum& receive, const Band& band, bool harmonic) {
  double power = 0;
  for (int f = 0; f < kFrequencies; ++f) {
    const double sent = std::norm(transmit[f]);
    power += band.power[f] * (harmonic ? sent * sent : sent) * std::norm(receive[f]);
  }
  return std::sqrt(power);
}

/// Frequencies of the transmitted wave.
Band transmitBand(const Probe& probe, const ImagingSettings& settings) {
  const double frequency_MHz = settings.harmonic ? settings.frequency_MHz / 2 : settings.frequency_MHz;
  return {frequency_MHz, probe.bandwidth * frequency_MHz};
}

/// Weight at a place (-1..1) of an aperture whose outer share is tapered by a cosine.
double taperedAt(double place, double tapered) {
  const double in = 1 - std::abs(place);
  return in >= tapered ? 1 : 0.5 - 0.5 * std::cos(std::numbers::pi * in / tapered);
}

double taperedShare(Apodization apodization) {
  switch (apodization) {
    case Apodization::Uniform:
      return 0;
    case Apodization::Tukey:
      return 0.5;
    case Apodization::Hann:
      break;
  }
  return 1;
}

/// Sources equally spaced over an aperture, with delays that focus their waves.
std::vector<Source> aperture(double width_mm, int count, double focus_mm, double tapered) {
  std::vector<Source> sources;
  for (int n = 0; n < count; ++n) {
    const double place = (2 * n + 1.0) / count - 1, at_mm = place * width_mm / 2;
    sources.push_back({at_mm, std::hypot(at_mm, focus_mm) - focus_mm, taperedAt(place, tapered)});
  }
  return sources;
}

int elementsIn(double width_mm, double pitch_mm) {
  constexpr int kFewest = 4;
  return std::max(kFewest, static_cast<int>(std::lround(width_mm / pitch_mm)));
}

}  // namespace

BeamField::BeamField(const Probe& probe, const ImagingSettings& settings) : spacing_mm_(settings.depth_mm / kNodes) {
  sumLateral(probe, settings);
  sumElevation(probe, settings);
}

void BeamField::sumLateral(const Probe& probe, const ImagingSettings& settings) {
  lateral_.entries = kLateralEntries;
  lateral_.value.resize(std::size_t(kNodes) * kLateralEntries);
  for (int n = 0; n < kNodes; ++n)
    lateral_.step_mm.push_back(kLateralStep * wavelength_mm(settings) * node_mm(n) /
                               receiveAperture_mm(probe, node_mm(n)));
  const double transmit_mm = transmitAperture_mm(probe, settings);
  const std::vector<Source> transmit =
      aperture(transmit_mm, elementsIn(transmit_mm, probe.pitch_mm), settings.focus_mm, kTransmitTaper);
  const Band sent = transmitBand(probe, settings),
             band(settings.frequency_MHz, probe.bandwidth * settings.frequency_MHz);
  tbb::parallel_for(0, kNodes, [&](int n) {
    const double range_mm = node_mm(n), receive_mm = receiveAperture_mm(probe, range_mm);
    const std::vector<Source> receive =
        aperture(receive_mm, elementsIn(receive_mm, probe.pitch_mm), range_mm, taperedShare(probe.apodization));
    float* value = lateral_.value.data() + std::size_t(n) * kLateralEntries;
    double onAxis = 0;
    for (int e = 0; e < kLateralEntries; ++e) {
      const double off_mm = e * lateral_.step_mm[n];
      const double here = twoWay(fieldAt(transmit, probe.pitch_mm, sent, off_mm, range_mm),
                                 fieldAt(receive, probe.pitch_mm, band, off_mm, range_mm), band, settings.harmonic);
      if (e == 0) onAxis = here;
      value[e] = static_cast<float>(here / onAxis);
    }
  });
}

void BeamField::sumElevation(const Probe& probe, const ImagingSettings& settings) {
  elevation_.entries = kElevationEntries;
  elevation_.value.resize(std::size_t(kNodes) * kElevationEntries);
  elevation_.step_mm.assign(kNodes, kElevationStep * probe.elementHeight_mm);
  const double pieces = kPiecesPerWavelength * probe.elementHeight_mm / wavelength_mm(settings);
  const std::vector<Source> strip = aperture(probe.elementHeight_mm, std::clamp(static_cast<int>(pieces), 16, 256),
                                             probe.elevationFocus_mm, kHeightTaper);
  const Band sent = transmitBand(probe, settings),
             band(settings.frequency_MHz, probe.bandwidth * settings.frequency_MHz);
  tbb::parallel_for(0, kNodes, [&](int n) {
    float* value = elevation_.value.data() + std::size_t(n) * kElevationEntries;
    double onAxis = 0;
    for (int e = 0; e < kElevationEntries; ++e) {
      const double off_mm = e * elevation_.step_mm[n];
      const Spectrum receive = fieldAt(strip, 0, band, off_mm, node_mm(n));
      const double here = settings.harmonic ? twoWay(fieldAt(strip, 0, sent, off_mm, node_mm(n)), receive, band, true)
                                            : twoWay(receive, receive, band, false);
      if (e == 0) onAxis = here;
      value[e] = static_cast<float>(here / onAxis);
    }
  });
  for (int n = 0; n < kNodes; ++n) {
    double sum = 0.5, power = 0.5, moment = 0;
    for (int e = 1; e < kElevationEntries; ++e) {
      const double here = elevation_.value[std::size_t(n) * kElevationEntries + e];
      sum += here, power += here * here, moment += here * here * e * e;
    }
    sliceIntegral_mm_.push_back(2 * sum * elevation_.step_mm[n]);
    sliceSd_mm_.push_back(std::sqrt(2 * moment / power) * elevation_.step_mm[n]);
  }
}

double BeamField::sliceReach_mm() const {
  return (kElevationEntries - 1) * elevation_.step_mm.front();
}

BeamField::Place BeamField::placeOf(double range_mm) const {
  const double at = std::clamp(range_mm / spacing_mm_ - 0.5, 0.0, kNodes - 1.0);
  const int node = std::min(static_cast<int>(at), kNodes - 2);
  return {node, at - node};
}

double BeamField::across(const Profiles& profiles, double off_mm, double range_mm) const {
  const Place place = placeOf(range_mm);
  const double step_mm = std::lerp(profiles.step_mm[place.node], profiles.step_mm[place.node + 1], place.fraction);
  const double at = std::abs(off_mm) / step_mm;
  if (at >= profiles.entries - 1) return 0;
  const int entry = static_cast<int>(at);
  const float* value = profiles.value.data() + std::size_t(place.node) * profiles.entries + entry;
  const auto between = [&](const float* v) { return std::lerp(double(v[0]), double(v[1]), at - entry); };
  return std::lerp(between(value), between(value + profiles.entries), place.fraction);
}

double BeamField::sliceIntegral_mm(double range_mm) const {
  const Place place = placeOf(range_mm);
  return std::lerp(sliceIntegral_mm_[place.node], sliceIntegral_mm_[place.node + 1], place.fraction);
}

double BeamField::sliceSd_mm(double range_mm) const {
  const Place place = placeOf(range_mm);
  return std::lerp(sliceSd_mm_[place.node], sliceSd_mm_[place.node + 1], place.fraction);
}

}  // namespace insonate
