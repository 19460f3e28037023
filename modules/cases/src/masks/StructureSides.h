#pragma once

#include "PartComposer.h"

#include <insonate/cases/LabelFile.h>

namespace insonate {

/// Names the vessels among the structures that were placed: by table, and by the side that the author has chosen, that
/// the name states, or on which the vessel lies. Sets StructureState::kDoubtful if none of these decides, or if name
/// and location disagree. Adds a note for each side that was decided by the location.
void nameVessels(const PatientCase& patient, const PartComposer& placed, const StructureChoices& choices,
                 LabelReadResult& result);

}  // namespace insonate
