#pragma once

#include <insonate/image/BloodFlow.h>

#include <array>
#include <complex>

namespace insonate {

/// Velocity of an oscillating flow in a round tube by relative distance from the center line, divided by its mean over
/// the cross-section: (1 - J0(L x) / J0(L)) / (1 - 2 J1(L) / (L J0(L))), L = i^(3/2) alpha (Womersley, J Physiol 1955;
/// 127:553). For alpha = 0, this is the parabola 2 (1 - x^2). The entries are those of BloodTube::profile_mmps.
std::array<std::complex<double>, BloodTube::kProfile> womersleyProfile(double alpha);

/// Womersley number R sqrt(omega / nu) of blood: the radius of the vessel divided by the thickness of the layer in
/// which viscosity slows an oscillation of this angular frequency.
double womersleyNumber(double radius_mm, double omega_perS);

}  // namespace insonate
