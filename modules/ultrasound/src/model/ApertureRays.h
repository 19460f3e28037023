#pragma once

#include <insonate/ultrasound/BeamGrid.h>

#include <array>
#include <vector>

namespace insonate {

/// Straight rays from a scanline's aperture to a point on the scanline, for computing the loss along each ray. Some
/// rays of an aperture pass beside the edge of a bone, so that the border of the bone's shadow is a penumbra as wide as
/// the cone of rays at that edge.
///
/// At each depth, half the cone's width at the face is the depth times half of 1 / F (mean of transmission and
/// reception, F the F-number), but at most half the array's maximum aperture. A ray's tangent is the same at all
/// depths, so that one sweep down the image follows all rays with this tangent. The weights of the rays are a triangle,
/// the convolution of two uniform apertures. The sweep interpolates linearly between scanlines, which blurs the border
/// by 1 mm at a depth of 40 mm (SD, 256 scanlines over 38 mm), so that no steps remain.
struct ApertureRays {
  static constexpr int kCount = 7;
  /// Tangent of each ray's angle to the scanline, relative to the tangent of the cone's edge.
  static constexpr std::array<double, kCount> kTangent{-0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75};
  static constexpr std::array<double, kCount> kWeight{1 / 16.0, 2 / 16.0, 3 / 16.0, 4 / 16.0,
                                                      3 / 16.0, 2 / 16.0, 1 / 16.0};
  /// Two-way amplitude at which the beam counts as fully absorbed: further losses are not added.
  static constexpr double kFaintest = 1e-15;
  /// Amplitude below which no echo is visible: -150 dB.
  static constexpr double kUnseen = 3.1622777e-8;

  ApertureRays() = default;
  ApertureRays(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid, int gates, double gate_mm);

  /// Returns the number of scanlines by which a ray moves sideways from the previous gate to this gate.
  double shift_lines(int ray, int gate) const { return kTangent[ray] * cone_lines[gate]; }

  /// [gate] number of scanlines, 0 to 1, by which the edge of the cone of rays moves from the previous gate; 0 if the
  /// effect `beam` is switched off.
  std::vector<double> cone_lines;
};

}  // namespace insonate
