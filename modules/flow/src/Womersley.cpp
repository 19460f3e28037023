#include "Womersley.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

using Complex = std::complex<double>;

/// Kinematic viscosity of blood, 3.5 mPa s divided by 1060 kg/m^3.
constexpr double kViscosity_mm2ps = 3.3;
/// Above this number, the profile is flat but for a layer of a fortieth of the radius, and the series would lose
/// digits.
constexpr double kLargest = 40;
constexpr double kSmallest = 1e-3;

/// Bessel functions J0 and J1 of complex argument, by their power series.
std::pair<Complex, Complex> bessel(Complex z) {
  const Complex q = -z * z / 4.0;
  Complex term = 1, j0 = 1, j1 = 1;
  for (int k = 1; k < 400; ++k) {
    term *= q / double(k * k);
    j0 += term;
    j1 += term / double(k + 1);
    if (std::abs(term) < 1e-17 * std::abs(j0) && k > std::abs(z)) break;
  }
  return {j0, j1 * z / 2.0};
}

}  // namespace

double womersleyNumber(double radius_mm, double omega_perS) {
  return radius_mm * std::sqrt(omega_perS / kViscosity_mm2ps);
}

std::array<Complex, BloodTube::kProfile> womersleyProfile(double alpha) {
  std::array<Complex, BloodTube::kProfile> profile;
  const Complex l = std::polar(std::clamp(alpha, kSmallest, kLargest), 0.75 * std::numbers::pi);
  const auto [j0, j1] = bessel(l);
  const Complex mean = 1.0 - 2.0 * j1 / (l * j0);
  for (int i = 0; i < BloodTube::kProfile; ++i) {
    const double x = double(i) / (BloodTube::kProfile - 1);
    // Both numerator and mean vanish with alpha; their limit is the parabola.
    profile[i] = alpha <= kSmallest ? Complex(2 * (1 - x * x)) : (1.0 - bessel(l * x).first / j0) / mean;
  }
  return profile;
}

}  // namespace insonate
