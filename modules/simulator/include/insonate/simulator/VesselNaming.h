#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Guide.h>
#include <insonate/segmentation/Recipe.h>
#include <insonate/tissue/OwnLabels.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate {

/// Name and label of a vessel that attempts may meet.
struct VesselKind {
  std::string_view name;  ///< as in NamedVessel, e.g. "right internal jugular vein"
  std::uint8_t label;     ///< kVein or kArtery
};

/// The large vessels of neck and upper chest, in the order of the form's list.
std::span<const VesselKind> vesselKinds();

/// Names the vessel at a place (patient space). The vessel's course is the center line of the place's label (see
/// centreLines()) that passes nearest to the place. A radius of the course is that of a circle with the area of the
/// connected cross-section there. `own` lists the author's own labels that are veins or arteries. Runs on the caller's
/// thread, a second or so for a whole CT. Fails if the place is in no vein or artery, if the vessel is too short to
/// have a center line, and if it is cancelled.
Result<NamedVessel> nameVessel(const LabelMap& labels, const OwnLabels& own, Vec3 place_mm, std::string name,
                               const Progress& progress = {});

/// Cuts a vessel in two at the point of its course nearest to a place. Both parts keep the name and the point of the
/// cut. Fails if that point is an end of the course.
Result<std::pair<NamedVessel, NamedVessel>> splitVessel(const NamedVessel& vessel, Vec3 place_mm);

/// Returns the vessels that the recipe labeled for those steps of the guide that name a vessel. Each vessel is found by
/// the clicks of its step. A vessel whose clicks no longer lie in a vein or artery is left out.
Result<std::vector<NamedVessel>> vesselsOf(const Guide& guide, const Recipe& recipe, const LabelMap& labels,
                                           const OwnLabels& own, const Progress& progress = {});

/// Adds a vessel, or replaces the vessel with the same name.
void putVessel(NamedVessel vessel, std::vector<NamedVessel>& vessels);

}  // namespace insonate
