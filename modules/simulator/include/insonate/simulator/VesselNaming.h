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

/// A vessel that attempts may meet.
struct VesselKind {
  std::string_view name;  ///< as in NamedVessel, e.g. "right internal jugular vein"
  std::uint8_t label;     ///< kVein or kArtery
};

/// The large vessels of neck and upper chest, in the order in which a form lists them.
std::span<const VesselKind> vesselKinds();

/// Names the vessel at a place (patient space). The course is the center line of the place's label (see centreLines())
/// that passes nearest to the place; a radius is that of a circle with the area of the connected section there. `own`
/// lists the author's own labels that are veins or arteries. Runs on the caller's thread, a second or so for a whole
/// CT. Fails if the place is in no vein or artery, if the vessel is too short to have a center line, and when
/// cancelled.
Result<NamedVessel> nameVessel(const LabelMap& labels, const OwnLabels& own, Vec3 place_mm, std::string name,
                               const Progress& progress = {});

/// Cuts a vessel in two at the point of its course nearest to a place. Both parts keep the name and the point of the
/// cut. Fails where that is an end of the course.
Result<std::pair<NamedVessel, NamedVessel>> splitVessel(const NamedVessel& vessel, Vec3 place_mm);

/// The vessels that the recipe's steps have labeled for steps of the guide that name one, each found by the step's
/// clicks. A vessel whose clicks lie in no vein or artery any more is left out.
Result<std::vector<NamedVessel>> vesselsOf(const Guide& guide, const Recipe& recipe, const LabelMap& labels,
                                           const OwnLabels& own, const Progress& progress = {});

/// Adds a vessel, in place of one with the same name.
void putVessel(NamedVessel vessel, std::vector<NamedVessel>& vessels);

}  // namespace insonate
