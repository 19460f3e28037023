#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <string>
#include <vector>

namespace insonate {

/// Targets, start poses and landmarks that a case lacks, proposed for the author to confirm. Patient LPS.
struct PlaceProposal {
  std::vector<Target> targets;
  std::vector<StartPose> startPoses;
  std::vector<Landmark> landmarks;
  std::vector<std::string> notes;  ///< vessels for which nothing could be proposed, and why, one sentence each
};

/// Proposes the following places, as far as the case lacks them:
/// - a target in each named vein of one kind, right before left: of the veins into which procedures lead (internal
///   jugular, subclavian, axillary, femoral and basilic veins), the kind that is the easiest to puncture in this case;
///   none if the case has a target already;
/// - for each target, old or new, over which no start pose lies, a transverse and a longitudinal start pose;
/// - the landmark `puncture_site` on the skin over the first target.
/// A target lies on the center line of its vein, where the vein is shallow and large, hardly covers an artery, and has
/// no lung close behind it; in the neck also near the neck's narrowest level. The formula is in the source. A
/// longitudinal image has the head on its left; in a vessel that runs across the body, the patient's right is on the
/// left. The poses may compress the vein where the skin is curved: simulator/TouchingPose.h corrects them. Takes about
/// 20 ms for each centimeter of vessel. Fails if CT and labels have different grids, and when canceled.
Result<PlaceProposal> proposePlaces(const CaseView& patient, const Progress& progress = {});

/// Returns the longitudinal pose at the place of a transverse one, along a vessel with the direction `along`.
StartPose longitudinalPose(const StartPose& transverse, Vec3 along);

/// Appends proposed places to those of a case.
void addPlaces(PlaceProposal proposal, CaseManifest& manifest);

}  // namespace insonate
