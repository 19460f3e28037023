#pragma once

#include <insonate/core/Vec3.h>

#include <QString>
#include <vector>

namespace insonate::prepare {

struct PrepareModel;

/// Names the vein or artery at the first of these places that lies in one (see simulator/VesselNaming.h). Returns at
/// once; the course is found on another thread, then added to the case's places as an undoable edit, or a sentence
/// says why there is none.
void nameVesselAt(PrepareModel& shared, std::vector<Vec3> places_mm, const QString& name);

}  // namespace insonate::prepare
