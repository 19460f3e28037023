#pragma once

#include <array>

namespace insonate::camera {

/// Blur of the image along one axis of a tag: a Gaussian (lens and pixel), convolved with a box (motion during the
/// exposure).
class BlurProfile {
 public:
  /// Values for an edge at a distance: the share of the blur on this side of the edge (0 to 1), and its derivatives by
  /// the distance and by the Gaussian's width.
  struct Edge {
    float share = 0, density = 0, byWidth = 0;
  };

  /// `sigma_mm` is the width of the Gaussian, `box_mm` that of the box; mm on the tag.
  BlurProfile(double sigma_mm, double box_mm);

  /// Distance beyond which the blur is zero, mm.
  double reach_mm() const { return reach_mm_; }
  Edge at(double distance_mm) const;

 private:
  static constexpr int kEntries = 96;
  double reach_mm_, perEntry_;
  std::array<Edge, kEntries + 2> table_{};
};

}  // namespace insonate::camera
