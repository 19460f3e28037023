#pragma once

#include "LabelPlan.h"

#include <insonate/image/Volume.h>

namespace insonate {

/// Fills small cavities of bone (marrow that a label map leaves out): unlabelled regions of a slice that bone encloses,
/// up to 120 mm2. The spinal canal is larger and stays.
void fillMarrow(LabelMap& labels);

/// Draws tubes and their walls into voxels that are unlabelled.
void drawTubes(LabelMap& labels, const std::vector<TubePlan>& tubes);

/// Builds a body around the structures: skin, subcutaneous fat, and between the structures muscle parted by connective
/// tissue and fat. Labeled voxels stay as they are. Fails when there is no structure, or slices are not axial.
Result<void> completeAnatomy(LabelMap& labels, const CompletionPlan& plan);

}  // namespace insonate
