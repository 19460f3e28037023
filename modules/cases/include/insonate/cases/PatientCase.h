#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>
#include <insonate/tissue/OwnLabels.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A named place for the probe: where its face's center is and how it looks. Patient LPS.
struct StartPose {
  std::string name;
  Vec3 position_mm;  ///< center of the probe face
  Vec3 axial;        ///< into the body, unit
  Vec3 lateral;      ///< toward the probe's marker, unit, at right angles to axial
};

/// A structure the procedure is about, e.g. the right internal jugular vein at the puncture level.
struct Target {
  std::string name;
  std::uint8_t label = 0;
  Vec3 position_mm;
};

/// A vessel, or the part of one that has a name of its own, by the middle of its lumen. Patient LPS.
struct NamedVessel {
  struct Point {
    Vec3 position_mm;
    double radius_mm = 0;
    bool operator==(const Point&) const = default;
  };
  std::string name;  ///< e.g. "right internal jugular vein"
  std::uint8_t label = 0;
  std::vector<Point> course;  ///< at least one, from one end to the other

  bool operator==(const NamedVessel&) const = default;
};

/// Distance to the wall of the vessel, as if it were round: negative in the lumen. Neither waits nor allocates.
double distanceToWall_mm(const NamedVessel& vessel, Vec3 patient_mm) noexcept;
/// Distance to the line along the middle. Neither waits nor allocates.
double distanceToCourse_mm(const NamedVessel& vessel, Vec3 patient_mm) noexcept;

/// A place that instructions refer to, e.g. the cricoid. Codes are those of cases/Landmarks.h, others are kept.
struct Landmark {
  std::string code;  ///< for programs, e.g. "clavicle_right"; empty for a place of the author's own
  std::string name;
  Vec3 position_mm;
};

/// Identity of a case at the time it was saved (see cases/CaseVersions.h).
struct CaseVersion {
  int number = 0;       ///< 1 for the first; 0 for a case that has never been saved as a version
  std::string content;  ///< contentHashOf() the case then
  std::string voxels;   ///< and voxelHashOf()
  std::string date;     ///< of the day on which it was saved, e.g. "2026-11-22"
  std::string author;   ///< may be empty
};

/// Display of a structure's surface in three dimensions.
struct StructureShown {
  double opacity = 1;  ///< 0..1
  bool visible = true;
  bool operator==(const StructureShown&) const = default;
};

/// The author's progress on a structure, as in 3D Slicer.
enum class LabelState : std::uint8_t { NotStarted, InProgress, Completed, Flagged };

/// "not started", "in progress", "completed", "flagged".
std::string_view nameOf(LabelState state);

/// Progress by label.
using LabelStates = std::map<std::uint8_t, LabelState>;

/// The author's word, else what can be seen: begun, or not.
LabelState stateOf(const LabelStates& states, std::uint8_t label, bool hasVoxels);

/// case.json. Every field but the version may be missing: defaults are used and said.
struct CaseManifest {
  static constexpr int kSchemaVersion = 1;
  int schemaVersion = kSchemaVersion;
  std::string title = "Untitled case";
  std::string description;
  std::string difficulty;  ///< the author's grade: "easy", "moderate", "hard" or empty (see cases/Difficulty.h)
  std::vector<Target> targets;
  std::vector<NamedVessel> vessels;   ///< tell vessels that share a label apart
  std::vector<StartPose> startPoses;  ///< the first is where a case begins
  std::vector<Landmark> landmarks;
  CaseVersion version;
  std::map<std::uint8_t, StructureShown> shown;  ///< by label, where the author chose it
  OwnLabels ownLabels;                           ///< what labels mean that the label table does not know
  LabelStates states;                            ///< where the author said one
  std::string source;                    ///< how the case came to be, without anything that identifies a patient
  std::vector<std::string> importNotes;  ///< what was changed or doubtful on the way from the CT, one sentence each
};

using LabelColour = std::array<std::uint8_t, 3>;  ///< sRGB
/// Color by label.
using LabelColours = std::map<std::uint8_t, LabelColour>;

/// A patient: CT and labels on one grid, and facts about them. Owns its volumes.
struct PatientCase {
  CaseManifest manifest;
  CtVolume ct;
  LabelMap labels;
  LabelColours colours{};  ///< the author's, where they differ from the label table's; kept in labels.seg.nrrd
};

/// The author's color of a label, else the label table's; gray for labels that the table does not know.
LabelColour colourOf(const LabelColours& colours, std::uint8_t label);

struct CaseReadResult {
  PatientCase patient;
  std::vector<std::string> notes;  ///< what was missing and which default was used, one sentence each
};

/// Reads `ct.nrrd`, `labels.seg.nrrd` (or labels.nrrd) and `case.json` of a folder. Fails on a missing or unreadable
/// volume, grids that differ, more than one component, or a newer schema.
Result<CaseReadResult> readCase(const std::filesystem::path& folder);

/// Refuses, before any work, a folder that a case could not be written to (see checkFolderTarget), and one that holds a
/// case already unless `replace`.
Result<void> checkCaseTarget(const std::filesystem::path& folder, bool replace);

/// Tells whether a path is one of the files of the case in `folder`, whether it exists yet or not, links included.
bool isCaseFile(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Writes the three files so that 3D Slicer and ITK-SNAP open them as they are, with ITK-SNAP's label description
/// beside them. A case that is there is replaced as a whole, in one step (see writeFolderAtomically), with other files
/// kept; until then, and on failure or cancellation, it is untouched.
Result<void> writeCase(const PatientCase& patient, const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace insonate
