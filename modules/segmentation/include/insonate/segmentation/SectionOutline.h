#pragma once

#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>
#include <insonate/segmentation/VesselCourse.h>
#include <insonate/segmentation/VesselTracking.h>

#include <vector>

namespace insonate {

/// Returns the outline of a label in a cross-section: on each ray from the center, the distance to the first point
/// outside of the label, up to 30 mm. The radii are 0 if the center is not in the label.
VesselOutline outlineOf(const LabelMap& labels, std::uint8_t label, const VesselFrame& frame);

/// Returns the point of an outline on one of its rays, patient space.
Vec3 cornerOf(const VesselOutline& outline, int ray);

/// Returns the outline after one corner was moved to a distance from the center. The corners up to 40 degrees to both
/// sides follow, the nearer the more, but not beyond this distance. A radius stays between 0.3 mm and 30 mm.
VesselOutline dragged(const VesselOutline& outline, int ray, double radius_mm);

/// A new outline of a vessel in one cross-section, and the piece of the vessel that it changes.
struct SectionOutline {
  std::vector<Vec3> line_mm;     ///< points of the vessel's center line about the section, about 1 mm apart
  int section = 0;               ///< number of the point of `line_mm` that is the center of the section
  std::vector<Vec3> corners_mm;  ///< corners of the outline, in the order of VesselOutline's rays
  double reach_mm = 4;           ///< distance along the vessel, to both sides, up to which the vessel changes
};

/// Returns the distance along the vessel, to both sides, up to which a new outline changes a label on this grid: 4 mm,
/// or twice the distance between voxels in the direction of the vessel, if this is more.
double outlineReach_mm(const VolumeGeometry& geometry, Vec3 along);

/// Returns this outline of the frame with a number, with the part of the course that reshapedVessel() needs.
SectionOutline outlineStep(const VesselCourse& course, std::size_t frame, const VesselOutline& outline,
                           double reach_mm);

/// Changes a label to a new outline in one section. Where the new outline differs from the label's present outline, the
/// sections within the reach get radii between the new outline and the present outline at the end of the reach. Only
/// voxels between the present and the new outlines change: they get the label, or, outside of the new outline, `rest`.
/// Beyond the reach, nothing changes. Fails if the corners or the line are not those of a section.
Result<Proposal> reshapedVessel(const LabelMap& labels, std::uint8_t label, std::uint8_t rest,
                                const SectionOutline& outline);

}  // namespace insonate
