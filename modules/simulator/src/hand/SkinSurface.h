#pragma once

#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace insonate {

/// Skin of a patient, on which probe and needle are moved by mouse and keys. The fraction of body (labels other than
/// background) is averaged over about 2 mm and stored on a grid of about 2 mm; the skin is the surface on which the
/// fraction is 0.5. Background enclosed by the body counts as body. The volume's outermost voxels continue outside it,
/// so that there is no skin at the end of the scan. Patient LPS, mm. The object is immutable.
class SkinSurface {
 public:
  static Result<SkinSurface> make(const LabelMap& labels);

  /// Returns the fraction of body around a point, 0 to 1.
  double body(Vec3 patient_mm) const;

  /// Returns the outward normal of the skin, averaged over about the footprint of a probe, so that noise, ears and
  /// folds have little effect. Where the skin has no clear normal (thin parts, far away), the previous normal `before`
  /// is kept.
  Vec3 normal(Vec3 patient_mm, Vec3 before) const;

  /// Returns the intersection of the skin with the line through `from_mm` along `outward`, within `reach_mm`. From a
  /// point in the body the search goes outward, else inward.
  std::optional<Vec3> along(Vec3 from_mm, Vec3 outward, double reach_mm) const;

  /// Returns the point of the skin nearest to a point.
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

  std::array<int, 3> size_{};    ///< number of grid nodes along each axis
  std::array<int, 3> voxels_{};  ///< number of voxels of the label map along each axis
  std::array<int, 3> parts_{};   ///< number of voxels per grid node, along each axis
  Vec3 spacing_mm_;              ///< distance between grid nodes
  Transform nodeFromPatient_, patientFromNode_;
  std::vector<float> body_;  ///< share of the surroundings that is body, not air, for each grid node; 0 to 1
  /// Fraction of body averaged over about the footprint of a probe, from which normals are computed; one value for each
  /// grid node.
  std::vector<float> footprint_;
  std::vector<std::array<float, 3>> skin_;  ///< points near the skin, patient LPS, mm
};

}  // namespace insonate
