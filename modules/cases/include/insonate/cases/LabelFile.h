#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Answer to the question on which side a vessel lies.
enum class SideAnswer { Right, Left, Both };

enum class StructureState {
  kTaken,
  kLeftOut,  ///< the author has left the structure out, or no label has its tissue
  kEmpty,    ///< no voxel of the structure lies in the CT
  kDoubtful  ///< a vessel whose side neither its name nor its location states, or about which they disagree
};

/// One structure of a label file, and the label that was assigned to it.
struct ReadStructure {
  std::int32_t number = 0;  ///< number of the label or segment in the file
  std::string name;         ///< name in the file, which may contain patient data; empty for a number without a name
  std::uint8_t label = 0;   ///< a label of the label table, or a label that the author has defined (OwnLabels)
  std::string known{};      ///< name in the table resources/maps/structures.json; empty if only the label is known
  std::string vessel{};     ///< name of the vessel in this program, e.g. "right internal jugular vein"; may be empty
  StructureState state = StructureState::kTaken;
  std::string doubt{};     ///< reason of kDoubtful, as a sentence
  std::string details{};   ///< what else the file says about it, e.g. "organ, drawn by hand, 34 contours"
  std::size_t voxels = 0;  ///< voxels in the CT, before other structures cover some of them; 0 if unknown

  /// Identifies the structure in StructureChoices: its name, or its number if it has none.
  std::string key() const { return name.empty() ? std::to_string(number) : name; }
};

/// The author's decisions on structures, by ReadStructure::key().
struct StructureChoices {
  std::map<std::string, bool> taken{};  ///< true: read; false: left out; missing: read unless it has no tissue
  std::set<std::string> only{};         ///< if not empty, structures are left out whose key() and number are not in it
  std::map<std::string, SideAnswer> sides{};  ///< sides of vessels, which replace those of names and locations
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
  /// structure of each voxel, as its place in `structures`, counted from 1; 0: none. Empty if it was not tracked.
  Volume<std::uint16_t> parts{};
  std::vector<NamedVessel> vessels{};  ///< vessels with names, if the caller has made them (simulator/ImportedLabels.h)
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
  StructureChoices choices{};
};

/// Reads labels for a case, and places them on the grid of the case's CT: a DICOM segmentation, an RT Structure Set,
/// any file that readLabelMap() reads, or a folder. A folder contains masks, one file for each structure with the
/// structure's name (TotalSegmentator), or label maps with names; its subfolders are read, too.
///
/// The structure of a segment, number or mask is identified by its code, then by its name, in the table
/// resources/maps/structures.json. A known structure of a mask, label map or structure set without a tissue of this
/// program, e.g. the spleen, is left out. An unknown structure becomes a label in LabelReadResult::own without a name,
/// since its name may contain patient data. Where structures of a folder or structure set overlap, the one with the
/// higher priority in the table wins; unknown structures lie below the known ones unless the author has chosen them
/// (StructureChoices). A vessel gets the side that its name states, else the side on which it lies;
/// StructureState::kDoubtful: neither decides.
///
/// Segmentations on another grid are resampled by the nearest voxel, label maps with names and masks by linear
/// interpolation, with a note. Labels that do not overlap the CT are refused. Adds a note if a segmentation refers to
/// another CT than the one from which the case was imported.
///
/// Each program numbers the structures of a label map differently. The names of the numbers are read from
/// `meaning.names` (a label description of ITK-SNAP, a color table of 3D Slicer, a JSON file of dcmqi, nnU-Net or
/// MONAI), else from NAME.label.txt beside the label map, else from the label table of a NIfTI header, else from
/// NAME.json, dataset.json, metadata.json, label_dict.json or labels.json beside the label map. Numbers without names
/// are refused, unless `meaning.areProgramLabels`.
Result<LabelReadResult> importLabels(const PatientCase& patient, const std::filesystem::path& source,
                                     const NumberMeaning& meaning = {}, const Progress& progress = {});

/// Reads one or more files and folders of one patient as importLabels() does, and combines them by the priority of
/// their structures.
Result<LabelReadResult> importLabelsTogether(const PatientCase& patient, std::span<const std::filesystem::path> sources,
                                             const NumberMeaning& meaning = {}, const Progress& progress = {});

/// Returns a sentence for each structure that a central line needs in a region which the structures belong to, and that
/// is missing, with the task of TotalSegmentator that finds it.
std::vector<std::string> missingForLines(std::span<const ReadStructure> structures);

/// Replaces a case's labels by imported labels, adds the named vessels, and adds a note to the manifest. The note
/// contains no names of segments.
void replaceLabels(LabelReadResult&& imported, PatientCase& patient);

/// Fails if writeLabelFile() does not accept the file name.
Result<void> checkLabelTarget(const std::filesystem::path& file);

/// Writes only the labels, as a 3D Slicer segmentation (NAME.seg.nrrd) with ITK-SNAP's label description
/// (NAME.label.txt) beside it. On failure, existing files are unchanged.
Result<void> writeLabelFile(const PatientCase& patient, const std::filesystem::path& file,
                            const Progress& progress = {});

}  // namespace insonate
