#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>
#include <insonate/core/Vec3.h>

#include <QString>
#include <string>
#include <vector>

namespace insonate::prepare {

struct PrepareModel;

/// Returns the first vein or artery in which one of these points lies, with these points as its clicks (see
/// simulator/VesselNaming.h). Fails if no point lies in a vessel, or if the vessel has no center line. Takes up to a
/// second; may be called on any thread.
Result<NamedVessel> vesselAt(const LabelMap& labels, const OwnLabels& own, const std::vector<Vec3>& places_mm,
                             const std::string& name);

/// Names the vessel that vesselAt() finds. Returns at once. The vessel's center line is computed on a background thread
/// and then added to the case's places as an undoable edit. If the center line cannot be computed, a message says why.
void nameVesselAt(PrepareModel& shared, std::vector<Vec3> places_mm, const QString& name);

}  // namespace insonate::prepare
