#pragma once

#include <insonate/core/Vec3.h>

#include <QString>
#include <vector>

namespace insonate::prepare {

struct PrepareModel;

/// Names the vein or artery at the first of these points that lies in one (see simulator/VesselNaming.h). Returns at
/// once: the vessel's course is computed on a background thread and then added to the case's places as an undoable
/// edit, with these points as its clicks. If it cannot be computed, a message says why.
void nameVesselAt(PrepareModel& shared, std::vector<Vec3> places_mm, const QString& name);

}  // namespace insonate::prepare
