#pragma once

#include "LabelPlan.h"

#include <insonate/image/Volume.h>

namespace insonate {

/// Fills small cavities of bone (marrow that a label map lacks): unlabeled regions of a slice, up to 120 mm2, that are
/// enclosed by bone. The spinal canal is larger and is not filled.
void fillMarrow(LabelMap& labels);

/// Draws tubes and their walls into unlabeled voxels.
void drawTubes(LabelMap& labels, const std::vector<TubePlan>& tubes);

/// Builds a body around the structures: skin, subcutaneous fat, and, between the structures, muscle separated by
/// connective tissue and fat. Labeled voxels are unchanged. Fails if there is no structure, or if the slices are not
/// axial.
Result<void> completeAnatomy(LabelMap& labels, const CompletionPlan& plan);

}  // namespace insonate
