#pragma once

#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace insonate {

/// The skin for a hand: the share of body in each place's neighborhood, about 2 mm wide, on a lattice of about 2 mm;
/// the skin is where the share is one half. Pockets of background inside the body count as body. Beyond the volume its
/// outermost voxels continue, so that there is no skin at the end of the scan. Patient LPS, mm. Immutable.
class SkinSurface {
 public:
  static Result<SkinSurface> make(const LabelMap& labels);

  /// Share of body, 0..1.
  double body(Vec3 patient_mm) const;

  /// Outward, averaged over about the footprint of a probe, so that noise, ears and folds do not throw it about. Where
  /// the skin says little (thin parts, far away), `before` decides.
  Vec3 normal(Vec3 patient_mm, Vec3 before) const;

  /// The skin on the line through a point along `outward`: out of the body from a place in it, else into it.
  std::optional<Vec3> along(Vec3 from_mm, Vec3 outward, double reach_mm) const;

  /// The skin nearest to any point.
  Vec3 nearest(Vec3 patient_mm) const;

  /// Within the outermost voxel centers of the volume.
  bool inVolume(Vec3 patient_mm) const;

 private:
  SkinSurface() = default;
  void average(const LabelMap& labels);
  void fillPockets();
  void smooth(double sd_mm, std::vector<float>& share) const;
  void collect();
  double sample(const std::vector<float>& share, Vec3 node) const;
  std::size_t offset(int i, int j, int k) const { return (std::size_t(k) * size_[1] + j) * size_[0] + i; }

  std::array<int, 3> size_{};    ///< nodes
  std::array<int, 3> voxels_{};  ///< of the label map
  std::array<int, 3> parts_{};   ///< voxels a node, along each axis
  Vec3 spacing_mm_;              ///< of nodes
  Transform nodeFromPatient_, patientFromNode_;
  std::vector<float> body_;                 ///< [node]
  std::vector<float> footprint_;            ///< [node] the same over about the footprint of a probe, for normals
  std::vector<std::array<float, 3>> skin_;  ///< patient positions near the skin, mm
};

}  // namespace insonate
