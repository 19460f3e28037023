#pragma once

#include <insonate/ultrasound/BeamGrid.h>

#include <array>
#include <vector>

namespace insonate {

/// Straight rays from a scanline's aperture to a point on it, for the loss on the way: an aperture looks past the edge
/// of bone, so that a shadow's border is a penumbra as wide as the cone of rays is at that edge.
///
/// The cone's half width is, per depth, half of 1 / F: the mean of the transmit and the receive aperture, no wider than
/// the array's largest. A ray's tangent is the same at all depths, so that one sweep down the image follows all rays of
/// one tangent. A ray weighs what two uniform apertures have of it: the convolution of both, a triangle. The sweep
/// interpolates linearly between scanlines, which blurs the border by 1 mm at 40 mm (SD, 256 scanlines over 38 mm): no
/// steps remain.
struct ApertureRays {
  static constexpr int kCount = 7;
  /// Tangents over that of the cone.
  static constexpr std::array<double, kCount> kTangent{-0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75};
  static constexpr std::array<double, kCount> kWeight{1 / 16.0, 2 / 16.0, 3 / 16.0, 4 / 16.0,
                                                      3 / 16.0, 2 / 16.0, 1 / 16.0};
  /// Amplitude, there and back, from which on nothing is left of the beam: losses add up no further.
  static constexpr double kFaintest = 1e-15;
  /// Amplitude below which nothing is seen: -150 dB.
  static constexpr double kUnseen = 3.1622777e-8;

  ApertureRays() = default;
  ApertureRays(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid, int gates, double gate_mm);

  /// Scanlines by which a ray moves from the gate before to this one.
  double shift_lines(int ray, int gate) const { return kTangent[ray] * cone_lines[gate]; }

  std::vector<double> cone_lines;  ///< [gate] by which the cone's edge moves, 0 to 1; 0 without the beam's width
};

}  // namespace insonate
