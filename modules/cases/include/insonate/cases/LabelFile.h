#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace insonate {

struct LabelReadResult {
  LabelMap labels;
  std::vector<std::string> notes;    ///< what was mapped, flattened or ignored, one sentence each
  LabelColours colours{};            ///< of the file's structures, where not the label table's
  OwnLabels own{};                   ///< structures that this program does not know, under numbers of their own
  std::set<std::uint8_t> foreign{};  ///< of these, whose names another program's user wrote
  LabelStates states{};              ///< where the file says so
};

/// Reads a label map file (NRRD, NIfTI, MetaImage; 3-D, whole numbers) with its own numbers, of any meaning.
Result<Volume<std::int32_t>> readLabelValues(const std::filesystem::path& file);

/// Reads a label map in this program's numbers (insonate/tissue/Labels.h). A 3D Slicer segmentation is mapped by each
/// segment's terminology, then by its name; a segment of unknown name becomes a label of its own (OwnLabels) with that
/// name and is noted. A plain label map keeps its numbers; above 255 or negative is refused. Layers are flattened,
/// later segments win.
Result<LabelReadResult> readLabelMap(const std::filesystem::path& file);

/// Reads labels for a case: a DICOM segmentation, or any file of readLabelMap, put on the grid of the case's CT.
/// Labels of another grid are resampled (nearest voxel), with a note; labels that lie elsewhere in the patient are
/// refused. The structure of a segment or label is found by its code, then by its name; an unknown one becomes a label
/// of its own, without its name, since people write anything there. Also notes if the segmentation refers to another
/// CT than the one that the case was imported from.
Result<LabelReadResult> importLabels(const PatientCase& patient, const std::filesystem::path& file,
                                     const std::filesystem::path& names = {}, const Progress& progress = {});

/// Replaces a case's labels by labels imported for it, and adds a note, without the names of segments.
void takeLabels(LabelReadResult&& imported, PatientCase& patient);

/// Refuses a name that writeLabelFile does not take.
Result<void> checkLabelTarget(const std::filesystem::path& file);

/// Writes the labels alone as a 3D Slicer segmentation (NAME.seg.nrrd), and ITK-SNAP's label description
/// (NAME.label.txt) beside it. On failure, an existing file of either kind is untouched.
Result<void> writeLabelFile(const PatientCase& patient, const std::filesystem::path& file,
                            const Progress& progress = {});

}  // namespace insonate
