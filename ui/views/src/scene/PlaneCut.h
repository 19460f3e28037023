#pragma once

#include <insonate/views/SceneOptions.h>

#include <cstdint>
#include <vector>

namespace insonate::views {

/// Section of a closed surface by a plane: the inside as triangles, and its outline. Patient LPS mm.
class PlaneCut {
 public:
  /// Cuts a surface: a few milliseconds for 100 000 triangles; allocates nothing after the first of a size.
  void cut(const Surface& surface, const ClippingPlane& plane);

  /// x, y, z of each point, in the plane.
  const std::vector<float>& points_mm() const { return points_mm_; }
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }  ///< three points each
  const std::vector<std::uint32_t>& outline() const { return outline_; }      ///< two points each
  void clear();

 private:
  struct Place {
    double across, up;
  };
  struct Edge {
    Place low, high;  ///< by `up`
    double acrossAt(double up) const;
  };
  void findEdges(const Surface& surface, const ClippingPlane& plane);
  void fill();
  void fillStrip(double low, double high);
  std::uint32_t add(Place place);

  Vec3 origin_mm_, across_, up_;
  std::vector<float> distances_, points_mm_;
  std::vector<Edge> edges_;  ///< by the lower end
  std::vector<double> levels_;
  std::vector<const Edge*> active_;
  std::vector<std::uint32_t> triangles_, outline_;
};

}  // namespace insonate::views
