#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstdint>

namespace insonate {

/// Scatterers lie on a lattice that is fixed in the patient and needs no memory: a node's amplitude is a hash of its
/// index. The lattice is longer along one axis. Thirteen fixed orientations exist; the orientation whose long axis is
/// nearest to the beam's elevation is used, so that speckle keeps its elevation correlation for any orientation of the
/// probe. Speckle stays the same while the probe slides, or turns by less than about 25 degrees.
struct ScattererLattice {
  std::uint32_t seed = 0;
  Mat3 latticeFromPatient;  ///< lattice index (not rounded) of a patient point

  ScattererLattice() = default;
  /// `pattern` selects independent speckle.
  ScattererLattice(Vec3 elevation, double pitch_mm, double elevationPitch_mm, std::uint32_t pattern);
};

/// Shifts of the fields of a hash. One hash contains the complex amplitudes of up to three independent looks: 5 bits
/// each, uniform, total power 1; re and im of each look in turn, three fields in each half of the hash.
inline constexpr int kScattererShift[6] = {0, 5, 10, 16, 21, 26};
inline constexpr double kScattererUnit = 0.07658395810674835;  // 1 / (sqrt(2) * SD of 0..31)
inline constexpr double kScattererMean = 15.5;

/// Amplitudes of all looks at a patient point: {re, im} per look, total variance 1. Interpolates between the four
/// corners of the tetrahedron that contains the point (Kuhn's division of the cell), and divides by the root of the
/// summed squared weights, so that the variance is the same everywhere.
std::array<double, 6> scattererAmplitudes(const ScattererLattice& lattice, Vec3 patient_mm);

/// Correlation of the amplitudes at two points with these distances, in pitches, perpendicular to and along the
/// elevation. Averaged over positions in the lattice and over perpendicular directions. Zero from the reach on.
double latticeCorrelation(double across_pitches, double elevation_pitches);
inline constexpr double kLatticeReach_pitches = 2.9;

}  // namespace insonate
