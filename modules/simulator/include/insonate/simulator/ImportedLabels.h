#pragma once

#include <insonate/cases/LabelFile.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

namespace insonate {

/// Makes LabelReadResult::vessels from the structures with ReadStructure::vessel. Structures with the same vessel are
/// one vessel. A vessel without a center line, for example a very short one, is left out with a note. Fails when
/// cancelled.
Result<void> makeImportedVessels(LabelReadResult& read, const Progress& progress = {});

/// Tells whether the labels need the automatic part (labelRest()): no skin was imported, without which a probe cannot
/// touch the patient.
bool needsRest(const LabelReadResult& read);

/// Labels the other voxels of the CT automatically (segmentation/AutoLabel.h). Skin, air, bone, fat and muscle are
/// those of the automatic labels; imported vessels, thyroid and cartilage replace fat, muscle and bone, and the other
/// imported structures replace fat and muscle. Adds a note. Fails with the errors of autoLabel().
Result<void> labelRest(const CtVolume& ct, LabelReadResult& read, const Progress& progress = {});

}  // namespace insonate
