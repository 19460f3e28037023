#pragma once

#include <insonate/image/Volume.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace insonate::segmentation {

/// A cross-section of a vessel: the part of the vessel in one plane that is connected to the point through which the
/// plane was laid. Patient space.
struct VesselSection {
  Vec3 center_mm;  ///< centroid of the section
  double area_mm2 = 0;
  double reach_mm = 0;  ///< distance from the centroid to the section's farthest point
  bool cut = false;     ///< true if the volume's edge cuts the section
};

/// Finds cross-sections of the vessels with one label. Reuses memory for one plane, so that finding many sections is
/// fast.
class SectionFinder {
 public:
  SectionFinder(const LabelMap& labels, std::uint8_t label);

  /// Finds the section through `at_mm`, perpendicular to the unit vector `axis`; no value if the label is not at
  /// `at_mm`.
  std::optional<VesselSection> find(Vec3 at_mm, Vec3 axis);
  /// Returns the centroid of the label's voxels within a ball; `at_mm` if there are none.
  Vec3 middleOfBall(Vec3 at_mm, double radius_mm) const;

 private:
  enum class Place { Inside, Outside, BeyondVolume };
  Place placeOf(Vec3 index) const;

  static constexpr double kStep_mm = 0.5;
  static constexpr int kHalf = 40;  ///< half width of the sampled square, 20 mm, in steps of kStep_mm
  static constexpr int kWidth = 2 * kHalf + 1;

  const LabelMap& labels_;
  std::uint8_t label_;
  Transform indexFromPatient_;
  std::vector<std::uint8_t> seen_;
  std::vector<int> open_;
};

}  // namespace insonate::segmentation
