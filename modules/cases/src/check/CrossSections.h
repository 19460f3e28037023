#pragma once

#include <insonate/cases/CaseView.h>

#include <vector>

namespace insonate::check {

/// Cross-section of a named vessel at a place of its course.
struct CrossSection {
  Vec3 place_mm;                       ///< patient LPS, on the course
  double area_mm2 = 0;                 ///< area of the vessel's label; 0 if there is no such label
  double width_mm = 0, height_mm = 0;  ///< axes of an ellipse with the same second moments
  bool isWhole = true;                 ///< false if the volume cuts it, or if another named vessel joins it here

  /// Returns the diameter of the circle that has the same area.
  double diameter_mm() const;
};

/// Measures a vessel across its course, every 2 mm. Where a section perpendicular to the course is larger than
/// `suspect_mm` (diameter), the smallest of this section and of those along the planes of the patient counts, since a
/// course that does not follow its vessel cuts it obliquely. Voxels that lie nearer to the wall of another named vessel
/// with the same label do not count.
std::vector<CrossSection> crossSectionsOf(const CaseView& patient, const NamedVessel& vessel, double suspect_mm);

}  // namespace insonate::check
