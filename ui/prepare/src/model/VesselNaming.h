#pragma once

#include <insonate/core/Vec3.h>

#include <QString>
#include <vector>

namespace insonate::prepare {

struct PrepareModel;

/// Names the first vein or artery in which one of these points lies (see simulator/VesselNaming.h). Returns at once.
/// The vessel's center line is computed on a background thread and then added to the case's places as an undoable edit,
/// with these points as the vessel's clicks. If the center line cannot be computed, a message says why.
void nameVesselAt(PrepareModel& shared, std::vector<Vec3> places_mm, const QString& name);

}  // namespace insonate::prepare
