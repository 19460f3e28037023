#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstdint>

namespace insonate {

/// Lattice of scatterers, fixed in the patient. The lattice needs no memory: a node's amplitude is a hash of its index.
/// The spacing is larger along one axis. Thirteen fixed orientations exist; the orientation whose long axis is nearest
/// to the beam's elevation is used, so that speckle keeps its elevation correlation for any orientation of the probe.
/// Speckle stays the same while the probe slides, or turns by less than about 25 degrees.
struct ScattererLattice {
  std::uint32_t seed = 0;
  Mat3 latticeFromPatient;  ///< maps a patient point to a fractional lattice index

  ScattererLattice() = default;
  /// Makes the lattice for an elevation direction (patient). Each value of `pattern` gives independent speckle.
  ScattererLattice(Vec3 elevation, double pitch_mm, double elevationPitch_mm, std::uint32_t pattern);
};

/// Bit positions in a node's hash of the real and imaginary parts of its amplitudes in up to three looks (renderings
/// with independent speckle): re and im of each look in turn, three numbers in each half of the hash. Each has 5 bits
/// and is uniform; the total power is 1.
inline constexpr int kScattererShift[6] = {0, 5, 10, 16, 21, 26};
inline constexpr double kScattererUnit = 0.07658395810674835;  // 1 / (sqrt(2) * SD of 0 to 31)
inline constexpr double kScattererMean = 15.5;

/// Returns the complex amplitudes of all looks (renderings with independent speckle) at a patient point: {re, im} per
/// look, total variance 1. Interpolates between the four corners of the tetrahedron that contains the point (Kuhn's
/// division of the cell), and divides by the root of the summed squared weights, so that the variance is the same
/// everywhere.
std::array<double, 6> scattererAmplitudes(const ScattererLattice& lattice, Vec3 patient_mm);

/// Returns the correlation of the scatterer amplitudes at two points with these distances, in lattice pitches,
/// perpendicular to and along the elevation direction; averaged over positions in the lattice and over perpendicular
/// directions. Zero from kLatticeReach_pitches on.
double latticeCorrelation(double across_pitches, double elevation_pitches);
inline constexpr double kLatticeReach_pitches = 2.9;

}  // namespace insonate
