#pragma once

#include <insonate/views/SceneOptions.h>

#include <cstdint>
#include <vector>

namespace insonate::views {

/// Section of a closed surface by a plane: the inside as triangles, and its outline. In the patient's frame (LPS, mm).
class PlaneCut {
 public:
  /// Cuts a surface. Takes a few milliseconds for 100 000 triangles; allocates no memory if an earlier section was as
  /// large.
  void cut(const Surface& surface, const ClippingPlane& plane);

  /// x, y, z of each point; all lie in the plane.
  const std::vector<float>& points_mm() const { return points_mm_; }
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }  ///< three point indices per triangle
  const std::vector<std::uint32_t>& outline() const { return outline_; }      ///< two point indices per segment
  void clear();

 private:
  struct Place {
    double across, up;
  };
  struct Edge {
    Place low, high;  ///< low: end with the lower `up`; high: end with the higher `up`
    double acrossAt(double up) const;
  };
  void findEdges(const Surface& surface, const ClippingPlane& plane);
  void fill();
  void fillStrip(double low, double high);
  std::uint32_t add(Place place);

  Vec3 origin_mm_, across_, up_;
  std::vector<float> distances_, points_mm_;
  std::vector<Edge> edges_;  ///< edges, sorted by their lower ends
  std::vector<double> levels_;
  std::vector<const Edge*> active_;
  std::vector<std::uint32_t> triangles_, outline_;
};

}  // namespace insonate::views
