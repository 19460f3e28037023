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

/// One structure of a label file, and the label that was assigned to it.
struct ReadStructure {
  std::int32_t number = 0;  ///< number of the label or segment in the file
  std::string name;         ///< name in the file, which may contain patient data; empty for a number without a name
  std::uint8_t label = 0;   ///< a label of the label table, or a label that the author has defined (OwnLabels)
};

struct LabelReadResult {
  LabelMap labels;
  std::vector<std::string> notes;  ///< structures that were mapped, flattened or ignored, one sentence each
  LabelColors colors{};            ///< colors of the file's structures that differ from the label table's
  OwnLabels own{};  ///< structures that this program does not know, by the label numbers assigned to them
  /// numbers of those labels in `own` whose names come from a file of another program
  std::set<std::uint8_t> foreign{};
  LabelStates states{};                     ///< the author's progress on each structure, if the file states it
  std::vector<ReadStructure> structures{};  ///< structures of the file that were read, for the author to check
  bool isUnnamed = false;                   ///< true: the file does not state the structures of its numbers
};

/// Reads a label map file (NRRD, NIfTI, MetaImage; 3-D, whole numbers) and returns the file's numbers unchanged.
Result<Volume<std::int32_t>> readLabelValues(const std::filesystem::path& file);

/// Reads a label map and converts it to this program's label numbers (insonate/tissue/Labels.h). A segment of a 3D
/// Slicer segmentation is mapped by its terminology, then by its name; a segment with an unknown name becomes a label
/// in LabelReadResult::own with that name, with a note. A plain label map keeps its numbers; numbers above 255 or below
/// 0 are refused. The layers of a segmentation are flattened: where segments overlap, the later one in the file
/// replaces the earlier one.
Result<LabelReadResult> readLabelMap(const std::filesystem::path& file);

/// Meaning of the numbers of a label map, for a file that does not state the meaning.
struct NumberMeaning {
  std::filesystem::path names{};  ///< file that names the numbers: see importLabels(); empty: none
  bool areProgramLabels = false;  ///< true: numbers without names are label numbers of this program
};

/// Reads labels for a case: a DICOM segmentation, an RT Structure Set (see StructureSet.h), or any file that
/// readLabelMap() reads, placed on the grid of the
/// case's CT. Labels on another grid are resampled (nearest voxel), with a note; labels that do not overlap the CT are
/// refused. The structure of a segment or label is identified by its code, then by its name. An unknown structure
/// becomes a label in LabelReadResult::own without a name, since its name may contain patient data. Adds a note if the
/// segmentation refers to another CT than the one from which the case was imported. Each program numbers the structures
/// of a label map differently. The names of the numbers are read from `meaning.names` (a label description of ITK-SNAP,
/// a color table of 3D Slicer, a JSON file of dcmqi or nnU-Net), else from NAME.label.txt beside the file, else from
/// the label table of a NIfTI header. Numbers without names are refused, unless `meaning.areProgramLabels`.
Result<LabelReadResult> importLabels(const PatientCase& patient, const std::filesystem::path& file,
                                     const NumberMeaning& meaning = {}, const Progress& progress = {});

/// Replaces a case's labels by imported labels, and adds a note to the manifest. The note contains no names of
/// segments.
void replaceLabels(LabelReadResult&& imported, PatientCase& patient);

/// Fails if writeLabelFile() does not accept the file name.
Result<void> checkLabelTarget(const std::filesystem::path& file);

/// Writes only the labels, as a 3D Slicer segmentation (NAME.seg.nrrd) with ITK-SNAP's label description
/// (NAME.label.txt) beside it. On failure, existing files are unchanged.
Result<void> writeLabelFile(const PatientCase& patient, const std::filesystem::path& file,
                            const Progress& progress = {});

}  // namespace insonate
