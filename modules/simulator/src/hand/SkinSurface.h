#pragma once

#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace insonate {

/// Skin on which a hand moves. At each place, the share of body is averaged over a neighborhood about 2 mm wide and
/// stored on a lattice of about 2 mm; the skin is the surface of share one half. Pockets of background inside the body
/// count as body. Beyond the volume its outermost voxels continue, so that there is no skin at the end of the scan.
/// Patient LPS, mm. Immutable.
class SkinSurface {
 public:
  static Result<SkinSurface> make(const LabelMap& labels);

  /// Share of body, 0..1.
  double body(Vec3 patient_mm) const;

  /// Outward normal, averaged over about the footprint of a probe, so that noise, ears and folds do not make it jump.
  /// If the skin has no clear normal there (thin parts, far away), the normal follows `before`.
  Vec3 normal(Vec3 patient_mm, Vec3 before) const;

  /// Intersection of the skin with the line through a point along `outward`. From a point in the body the search goes
  /// outward, else inward.
  std::optional<Vec3> along(Vec3 from_mm, Vec3 outward, double reach_mm) const;

  /// The point of the skin nearest to any point.
  Vec3 nearest(Vec3 patient_mm) const;

  /// Tells whether a point lies within the outermost voxel centers of the volume.
  bool inVolume(Vec3 patient_mm) const;

 private:
  SkinSurface() = default;
  void average(const LabelMap& labels);
  void fillPockets();
  void smooth(double sd_mm, std::vector<float>& share) const;
  void collect();
  double sample(const std::vector<float>& share, Vec3 node) const;
  std::size_t offset(int i, int j, int k) const { return (std::size_t(k) * size_[1] + j) * size_[0] + i; }

  std::array<int, 3> size_{};    ///< number of nodes
  std::array<int, 3> voxels_{};  ///< number of voxels of the label map
  std::array<int, 3> parts_{};   ///< voxels per node, along each axis
  Vec3 spacing_mm_;              ///< distance between nodes
  Transform nodeFromPatient_, patientFromNode_;
  std::vector<float> body_;       ///< [node] share of body
  std::vector<float> footprint_;  ///< [node] share of body, averaged over about the footprint of a probe; for normals
  std::vector<std::array<float, 3>> skin_;  ///< patient positions near the skin, mm
};

}  // namespace insonate
