#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

struct LabelReadResult {
  LabelMap labels;
  std::vector<std::string> notes;  ///< what was mapped, flattened or ignored, one sentence each
  LabelColours colours{};          ///< of a 3D Slicer segmentation's known segments, where not the label table's
};

/// Reads a label map file (NRRD, NIfTI, MetaImage; 3-D, whole numbers) with its own numbers, whatever they mean.
Result<Volume<std::int32_t>> readLabelValues(const std::filesystem::path& file);

/// Reads a label map in this program's numbers (insonate/tissue/Labels.h). A 3D Slicer segmentation is mapped by each
/// segment's terminology, then by its name; a segment of unknown name becomes soft tissue and is noted. A plain label
/// map keeps its numbers; above 255 or negative is refused. Layers are flattened, later segments win.
Result<LabelReadResult> readLabelMap(const std::filesystem::path& file);

}  // namespace insonate
