#include "pointspread/Spread.h"

#include <algorithm>
#include <cmath>

namespace insonate::bench {
namespace {

constexpr double kAside_mm = 2;

/// Width in indices at a share of the maximum, between linear crossings; 0 if a side does not fall to this share.
double widthAt(const std::vector<double>& profile, double share) {
  const auto top = std::max_element(profile.begin(), profile.end());
  const double level = share * *top;
  const int middle = int(top - profile.begin()), size = int(profile.size());
  int left = middle, right = middle;
  while (left >= 0 && profile[left] > level) --left;
  while (right < size && profile[right] > level) ++right;
  if (left < 0 || right == size) return 0;
  const double from = left + (level - profile[left]) / (profile[left + 1] - profile[left]);
  const double to = right - (level - profile[right]) / (profile[right - 1] - profile[right]);
  return to - from;
}

/// Width in indices between the outermost places that reach a share of the maximum: side lobes count.
double outerWidthAt(const std::vector<double>& profile, double share) {
  const double level = share * *std::ranges::max_element(profile);
  int left = 0, right = int(profile.size()) - 1;
  while (profile[left] < level) ++left;
  while (profile[right] < level) --right;
  if (left == 0 || right == int(profile.size()) - 1) return 0;
  return right - left + (profile[left] - level) / (profile[left] - profile[left - 1]) +
         (profile[right] - level) / (profile[right] - profile[right + 1]);
}

/// Energy from outside a lumen relative to all energy, in dB: the leakage of speckle into its middle.
double leak_dB(const Spread& spread, double diameter_mm) {
  double outside = 0, all = 0;
  for (int x = 0; x < spread.across; ++x)
    for (int z = 0; z < spread.along; ++z) {
      const double power = std::norm(spread.echo[std::size_t(x) * spread.along + z]);
      const double off_mm = std::hypot((x - spread.across / 2) * spread.x_mm, (z - spread.along / 2) * spread.z_mm);
      all += power;
      if (off_mm > diameter_mm / 2) outside += power;
    }
  return 10 * std::log10(std::max(outside / all, 1e-12));
}

/// Highest level beyond the first minimum to either side of the peak, in dB. Ripples below a thousandth are rounding.
double sideLobe_dB(const std::vector<double>& profile) {
  constexpr double kLeast_dB = -120, kRipple = 1e-3;
  const auto top = std::max_element(profile.begin(), profile.end());
  const int middle = int(top - profile.begin()), size = int(profile.size());
  double lobe = 0;
  for (const int side : {-1, 1}) {
    int at = middle + side;
    while (at + side >= 0 && at + side < size && profile[at + side] < profile[at] * (1 + kRipple)) at += side;
    for (; at >= 0 && at < size; at += side)
      if (at + side >= 0 && at + side < size && profile[at + side] > profile[at] * (1 + kRipple))
        lobe = std::max(lobe, profile[at + side]);
  }
  return lobe > 0 ? std::max(kLeast_dB, 20 * std::log10(lobe / *top)) : kLeast_dB;
}

/// Correlation of intensity by shift, of fully developed speckle: the squared magnitude of the echo's autocorrelation.
std::vector<double> speckleCorrelation(const Spread& spread, bool across) {
  const int steps = (across ? spread.across : spread.along) / 2;
  std::vector<double> correlation(2 * steps + 1);
  for (int shift = 0; shift <= steps; ++shift) {
    const int dx = across ? shift : 0, dz = across ? 0 : shift;
    std::complex<double> sum;
    for (int x = 0; x + dx < spread.across; ++x)
      for (int z = 0; z + dz < spread.along; ++z)
        sum += spread.echo[std::size_t(x) * spread.along + z] *
               std::conj(spread.echo[std::size_t(x + dx) * spread.along + z + dz]);
    correlation[steps + shift] = correlation[steps - shift] = std::norm(sum);
  }
  return correlation;
}

}  // namespace

std::vector<double> Spread::peaksAcross() const {
  std::vector<double> peaks(across);
  for (int x = 0; x < across; ++x)
    for (int z = 0; z < along; ++z) peaks[x] = std::max(peaks[x], std::abs(echo[std::size_t(x) * along + z]));
  return peaks;
}

PointSpreadFigures figuresOf(const Spread& spread) {
  const std::vector<double> peaks = spread.peaksAcross();
  const double top = *std::max_element(peaks.begin(), peaks.end());
  std::vector<double> beam(spread.along);
  for (int z = 0; z < spread.along; ++z)
    beam[z] = std::abs(spread.echo[std::size_t(spread.across / 2) * spread.along + z]);
  double aside = 0;
  for (int x = 0; x < spread.across; ++x)
    if (std::abs(x - spread.across / 2) * spread.x_mm >= kAside_mm) aside = std::max(aside, peaks[x]);
  return {.lateral_mm = widthAt(peaks, 0.5) * spread.x_mm,
          .lateral20dB_mm = outerWidthAt(peaks, 0.1) * spread.x_mm,
          .axial_mm = widthAt(beam, 0.5) * spread.z_mm,
          .slice_mm = widthAt(spread.slice, 0.5) * spread.y_mm,
          .endLateral_mm = widthAt(spread.endAcross, 0.5) * spread.x_mm,
          .aside_dB = 20 * std::log10(std::max(aside / top, 1e-6)),
          .sideLobe_dB = sideLobe_dB(peaks),
          .lumen4_dB = leak_dB(spread, 4),
          .lumen8_dB = leak_dB(spread, 8),
          .speckleLateral_mm = widthAt(speckleCorrelation(spread, true), 0.5) * spread.x_mm,
          .speckleAxial_mm = widthAt(speckleCorrelation(spread, false), 0.5) * spread.z_mm};
}

}  // namespace insonate::bench
