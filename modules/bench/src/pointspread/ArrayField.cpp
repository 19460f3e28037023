#include "pointspread/ArrayField.h"

#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::bench {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double kElementShare = 0.9;  ///< share of the pitch; the remainder is kerf
constexpr int kFrequencies = 64;

double apodizationAt(Apodization apodization, double share) {
  const double off = std::abs(share);  // 0 in the middle, 1 at the ends
  switch (apodization) {
    case Apodization::Uniform:
      return 1;
    case Apodization::Tukey:
      return off < 0.5 ? 1 : 0.5 + 0.5 * std::cos(2 * pi * (off - 0.5));
    case Apodization::Hann:
      break;
  }
  return 0.5 + 0.5 * std::cos(pi * off);
}

double sinc(double x) {
  return std::abs(x) < 1e-9 ? 1 : std::sin(x) / x;
}

}  // namespace

ArrayField::ArrayField(const Probe& probe, const ImagingSettings& settings, double end_mm)
    : probe_(probe), frequency_MHz_(settings.frequency_MHz), transmitFocus_mm_(settings.focus_mm), end_mm_(end_mm) {
  // A Gaussian of -6 dB at half the bandwidth from its center, sampled until it has fallen by 60 dB.
  const double half_MHz = probe.bandwidth * frequency_MHz_ / 2, reach_MHz = half_MHz * std::sqrt(10.0);
  for (int n = 0; n < kFrequencies; ++n) {
    const double off_MHz = reach_MHz * ((n + 0.5) / kFrequencies * 2 - 1);
    if (frequency_MHz_ + off_MHz <= 0) continue;
    waveNumber_radPmm_.push_back(2 * pi * (frequency_MHz_ + off_MHz) / kSoundSpeed_mmPerUs);
    spectrum_.push_back(std::exp2(-(off_MHz / half_MHz) * (off_MHz / half_MHz)));
  }
  // Pieces as wide as a third of the shortest wave.
  const double piece_mm = 2 * pi / waveNumber_radPmm_.back() / 3;
  const int pieces = std::max(1, static_cast<int>(std::ceil(probe.elementHeight_mm / piece_mm)));
  for (int m = 0; m < pieces; ++m) {
    height_mm_.push_back(probe.elementHeight_mm * ((m + 0.5) / pieces - 0.5));
    lens_mm_.push_back(probe.elevationFocus_mm - std::hypot(probe.elevationFocus_mm, height_mm_.back()));
  }
}

ArrayField::Aperture ArrayField::apertureOf(double width_mm, double focus_mm, Apodization apodization) const {
  Aperture aperture;
  const double half_mm = std::min(width_mm, probe_.maxAperture_mm) / 2;
  const int reach = std::max(1, static_cast<int>(half_mm / probe_.pitch_mm));
  for (int n = -reach; n < reach; ++n) {
    const double x_mm = (n + 0.5) * probe_.pitch_mm;
    if (x_mm < -end_mm_) continue;
    aperture.x_mm.push_back(x_mm);
    aperture.weight.push_back(apodizationAt(apodization, x_mm / half_mm));
    aperture.delay_mm.push_back(std::hypot(focus_mm, x_mm) - focus_mm);
  }
  return aperture;
}

std::vector<Complex> ArrayField::pressure(const Aperture& aperture, Vec3 point_mm) const {
  std::vector<Complex> sum(spectrum_.size());
  const double half_mm = kElementShare * probe_.pitch_mm / 2;
  const double step_radPmm = waveNumber_radPmm_[1] - waveNumber_radPmm_[0];
  std::vector<double> directivity(sum.size());
  for (std::size_t n = 0; n < aperture.x_mm.size(); ++n) {
    const double x_mm = point_mm.x - aperture.x_mm[n];
    const double sine = x_mm / std::hypot(x_mm, point_mm.z);
    for (std::size_t f = 0; f < sum.size(); ++f) directivity[f] = sinc(waveNumber_radPmm_[f] * half_mm * sine);
    for (std::size_t m = 0; m < height_mm_.size(); ++m) {
      const double r_mm = std::hypot(std::hypot(x_mm, point_mm.y - height_mm_[m]), point_mm.z);
      const double way_mm = r_mm - aperture.delay_mm[n] + lens_mm_[m];
      const double strength = aperture.weight[n] / r_mm * point_mm.z / r_mm;
      // The phase turns by the same angle from each frequency to the next.
      Complex wave = std::polar(strength, waveNumber_radPmm_[0] * way_mm);
      const Complex turn = std::polar(1.0, step_radPmm * way_mm);
      for (std::size_t f = 0; f < sum.size(); ++f, wave *= turn) sum[f] += wave * directivity[f];
    }
  }
  return sum;
}

std::vector<Complex> ArrayField::echo(Vec3 point_mm, double focus_mm) const {
  const Aperture sends = apertureOf(transmitFocus_mm_ / probe_.transmitFNumber, transmitFocus_mm_, Apodization::Tukey);
  const Aperture hears = apertureOf(focus_mm / probe_.receiveFNumber, focus_mm, probe_.apodization);
  std::vector<Complex> spectrum = pressure(sends, point_mm);
  const std::vector<Complex> received = pressure(hears, point_mm);
  for (std::size_t f = 0; f < spectrum.size(); ++f) spectrum[f] *= received[f] * spectrum_[f];

  std::vector<Complex> echo;
  constexpr int kSteps = static_cast<int>(kReach_mm / kStep_mm + 0.5);
  for (int t = -kSteps; t <= kSteps; ++t) {
    const double way_mm = 2 * (focus_mm + t * kStep_mm);
    const double middle_radPmm = 2 * pi * frequency_MHz_ / kSoundSpeed_mmPerUs;
    Complex sum;
    for (std::size_t f = 0; f < spectrum.size(); ++f)
      sum += spectrum[f] * std::polar(1.0, -(waveNumber_radPmm_[f] - middle_radPmm) * way_mm);
    echo.push_back(sum);
  }
  return echo;
}

}  // namespace insonate::bench
