#pragma once

#include <insonate/image/Volume.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace insonate::segmentation {

/// The part of a vessel in one plane that hangs together with the point where it was looked for. Patient space.
struct VesselSection {
  Vec3 centre_mm;  ///< its centroid
  double area_mm2 = 0;
  double reach_mm = 0;  ///< from the center to its farthest point
  bool cut = false;     ///< the volume's edge cuts it
};

/// Looks at planes through the voxels of one label. Holds memory for one plane, so that many are cheap.
class SectionFinder {
 public:
  SectionFinder(const LabelMap& labels, std::uint8_t label);

  /// Finds the section through `at_mm`, perpendicular to the unit vector `axis`; none if the label is not there.
  std::optional<VesselSection> find(Vec3 at_mm, Vec3 axis);
  /// The middle of the label's voxels within a ball, or the point itself where there are none.
  Vec3 middleOfBall(Vec3 at_mm, double radius_mm) const;

 private:
  enum class Place { Inside, Outside, BeyondVolume };
  Place placeOf(Vec3 index) const;

  static constexpr double kStep_mm = 0.5;
  static constexpr int kHalf = 40;  ///< 20 mm to each side
  static constexpr int kWidth = 2 * kHalf + 1;

  const LabelMap& labels_;
  std::uint8_t label_;
  Transform indexFromPatient_;
  std::vector<std::uint8_t> seen_;
  std::vector<int> open_;
};

}  // namespace insonate::segmentation
