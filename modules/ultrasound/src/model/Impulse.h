#pragma once

namespace insonate {

/// Spreads a boundary's echo over gates as a list of weights, so that the echo does not depend on the boundary's
/// position between gates.
///
/// Each scanline of each elevation plane represents the tissue within half a line's and half a plane's distance to its
/// sides. On a sloping boundary, the echo is therefore spread along the scanline over a box of width = hypot(lateral
/// slope * line distance, elevation slope * plane distance). Without this spread, a sloping boundary would appear as
/// separate lines, one per plane. The box is convolved with a quadratic B-spline, so that sloping boundaries do not
/// shimmer in motion.
struct Impulse {
  /// Limits of the box's width: below kNarrowest_gates only the spline is used; wider boxes are limited to
  /// kWidest_gates.
  static constexpr double kNarrowest_gates = 0.01, kWidest_gates = 12;
  static constexpr int kMost = 17;

  int first = 0;  ///< gate of the first weight
  int count = 0;
  float weight[kMost];  ///< weights of the gates, with unit sum

  /// `gate`: center of the echo, may be fractional. `width`: width of the box, in gates.
  Impulse(double gate, double width);
};

}  // namespace insonate
