#pragma once

namespace insonate {

/// A boundary's echo as weights of gates, spread so that it does not depend on its position between gates.
///
/// The crossing of one scanline of an elevation plane at one range represents everything within half a line's and half
/// a plane's distance to its sides. On a sloping boundary, this spreads the echo over a box of width = hypot(lateral
/// slope * line distance, elevation slope * plane distance). Without this, a slope would appear as separate lines, one
/// per plane. The box is convolved with a quadratic B-spline, so that slopes do not shimmer.
struct Impulse {
  /// Narrower boxes are replaced by the spline alone.
  static constexpr double kNarrowest_gates = 0.01, kWidest_gates = 12;
  static constexpr int kMost = 17;

  int first = 0;  ///< gate of the first weight
  int count = 0;
  float weight[kMost];  ///< weights of the gates, with unit sum

  /// `gate`: center of the echo, may be fractional. `width`: width of the box, in gates.
  Impulse(double gate, double width);
};

}  // namespace insonate
