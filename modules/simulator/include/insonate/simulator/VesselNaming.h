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

/// Name and label of a kind of vessel that an author may name in a case.
struct VesselKind {
  std::string_view name;  ///< name of the vessel, e.g. "right internal jugular vein"
  std::uint8_t label;     ///< label of the vessel: kVein or kArtery
};

/// Returns the kinds of large vessels of neck and upper chest, in the order in which a form should list them.
std::span<const VesselKind> vesselKinds();

/// Makes a named vessel from the vein or artery at a position (patient space). The vessel's course is the center line
/// (centerLines() of the label there) that passes nearest to the position. The radius at each point of the course is
/// that of a circle with the vessel's cross-sectional area. `own` contains the labels that the author has defined, some
/// of which may be veins or arteries. Takes about a second for a whole CT, on the caller's thread. Fails if the
/// position is in no vein or artery, if the vessel is too short to have a center line, and when cancelled.
Result<NamedVessel> nameVessel(const LabelMap& labels, const OwnLabels& own, Vec3 place_mm, std::string name,
                               const Progress& progress = {});

/// Makes a named vessel from all voxels with this label, a vein or artery. The vessel's course is the longest center
/// line. Fails if there is no center line, and when cancelled.
Result<NamedVessel> longestVessel(const LabelMap& labels, std::uint8_t label, std::string name,
                                  const Progress& progress = {});

/// Splits a vessel into two at the point of its center line nearest to `place_mm`. Both parts have the name of the
/// vessel and contain that point; each click belongs to the nearer part. Fails if the point is an end of the center
/// line.
Result<std::pair<NamedVessel, NamedVessel>> splitVessel(const NamedVessel& vessel, Vec3 place_mm);

/// Returns the named vessels that result from the segmentation guide: each step of `guide` that names a vessel has
/// clicks in `recipe`, and the vessel is found at those clicks. A vessel whose clicks do not lie in a vein or artery is
/// left out. Fails when cancelled.
Result<std::vector<NamedVessel>> vesselsFromGuide(const Guide& guide, const Recipe& recipe, const LabelMap& labels,
                                                  const OwnLabels& own, const Progress& progress = {});

/// Adds a vessel to `vessels`, or replaces the vessel with the same name.
void addOrReplaceVessel(NamedVessel vessel, std::vector<NamedVessel>& vessels);

}  // namespace insonate
