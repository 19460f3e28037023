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

/// A named pose of the probe, patient LPS.
struct StartPose {
  std::string name;
  Vec3 position_mm;  ///< center of the probe face
  Vec3 axial;        ///< direction into the body, unit
  Vec3 lateral;      ///< direction toward the probe's marker, unit, perpendicular to axial
  bool operator==(const StartPose&) const = default;
};

/// A point in a structure to which the procedure applies, e.g. in the right internal jugular vein at the puncture
/// level. Patient LPS.
struct Target {
  std::string name;
  std::uint8_t label = 0;
  Vec3 position_mm;
  bool operator==(const Target&) const = default;
};

/// A vessel, or a named part of a vessel, described by the center line of its lumen. Patient LPS.
struct NamedVessel {
  struct Point {
    Vec3 position_mm;
    double radius_mm = 0;
    bool operator==(const Point&) const = default;
  };
  std::string name;  ///< name of the vessel, e.g. "right internal jugular vein"
  std::uint8_t label = 0;
  std::vector<Point> course;      ///< center line from one end to the other, at least one point
  std::vector<Vec3> clicks_mm{};  ///< points in the lumen that the author has clicked; may be empty

  bool operator==(const NamedVessel&) const = default;
};

/// Returns the distance from a point to the vessel's wall, negative in the lumen. The vessel is treated as round.
/// Neither waits nor allocates.
double distanceToWall_mm(const NamedVessel& vessel, Vec3 patient_mm) noexcept;
/// Returns the distance from a point to the vessel's center line. Neither waits nor allocates.
double distanceToCenterLine_mm(const NamedVessel& vessel, Vec3 patient_mm) noexcept;

/// A landmark to which instructions refer, e.g. the cricoid. Codes are those of cases/Landmarks.h; other codes are kept
/// when a case is read and written.
struct Landmark {
  std::string code;  ///< code for programs, e.g. "clavicle_right"; empty for a landmark that the author defined
  std::string name;
  Vec3 position_mm;
  bool operator==(const Landmark&) const = default;
};

/// Identity of a case at the time it was saved (see cases/CaseVersions.h).
struct CaseVersion {
  int number = 0;       ///< number of the version: 1 for the first; 0 for a case that has never been saved as a version
  std::string content;  ///< contentHashOf() of the case when it was saved
  std::string voxels;   ///< voxelHashOf() of the case when it was saved
  std::string date;     ///< the day on which it was saved, e.g. "2026-11-22"
  std::string author;   ///< person who saved the version; may be empty
};

/// Display settings of a structure's surface in 3D.
struct SurfaceAppearance {
  double opacity = 1;  ///< opacity of the surface, 0 to 1
  bool visible = true;
  bool operator==(const SurfaceAppearance&) const = default;
};

/// The author's progress in labeling a structure. The states are those of 3D Slicer.
enum class LabelState : std::uint8_t { NotStarted, InProgress, Completed, Flagged };

/// Returns "not started", "in progress", "completed" or "flagged".
std::string_view nameOf(LabelState state);

/// The author's progress in labeling each structure, by label.
using LabelStates = std::map<std::uint8_t, LabelState>;

/// Returns the state that the author has set. If none is set, returns InProgress for a label with voxels, else
/// NotStarted.
LabelState stateOf(const LabelStates& states, std::uint8_t label, bool hasVoxels);

/// Contents of case.json. Every field except the version may be missing; the reader then uses a default and adds a
/// note.
struct CaseManifest {
  static constexpr int kSchemaVersion = 1;
  int schemaVersion = kSchemaVersion;
  std::string title = "Untitled case";
  std::string description;
  std::string difficulty;  ///< the author's grade: "easy", "moderate", "hard" or empty (see cases/Difficulty.h)
  std::vector<Target> targets;
  std::vector<NamedVessel> vessels;   ///< named vessels, so that vessels that share a label can be distinguished
  std::vector<StartPose> startPoses;  ///< poses of the probe that the user can choose; training begins at the first one
  std::vector<Landmark> landmarks;
  CaseVersion version;
  std::map<std::uint8_t, SurfaceAppearance> shown;  ///< display settings by label, if the author set them
  OwnLabels ownLabels;                   ///< the author's own structures, which the label table does not contain
  LabelStates states;                    ///< progress in labeling each structure, if the author set it
  std::string source;                    ///< origin of the case, without anything that identifies a patient
  std::vector<std::string> importNotes;  ///< changes that the import made, and points to check, one sentence each
};

using LabelColor = std::array<std::uint8_t, 3>;  ///< color of a label, sRGB
/// Colors of structures, by label.
using LabelColors = std::map<std::uint8_t, LabelColor>;

/// A patient: CT and labels on one grid, and the manifest. Owns its volumes.
struct PatientCase {
  CaseManifest manifest;
  CtVolume ct;
  LabelMap labels;
  LabelColors colors{};  ///< colors that the author chose instead of the label table's; stored in labels.seg.nrrd
};

/// Returns the author's color of a label, else the label table's; gray for labels that the table does not know.
LabelColor caseLabelColor(const LabelColors& colors, std::uint8_t label);
/// Tells whether a color in a file is no choice of the author: the label table's color of the label, or the color of 3D
/// Slicer, which the label table had in earlier versions.
bool isUsualColor(std::uint8_t label, const LabelColor& color);

struct CaseReadResult {
  PatientCase patient;
  std::vector<std::string> notes;  ///< missing fields and the defaults used for them, one sentence each
};

/// Reads a case from `ct.nrrd`, `labels.seg.nrrd` (or `labels.nrrd`) and `case.json` in a folder. Fails if a volume is
/// missing or cannot be read, if the grids differ, if a voxel has more than one component, or if a newer version of the
/// program wrote the case (schemaVersion).
Result<CaseReadResult> readCase(const std::filesystem::path& folder);

/// Refuses, before any work, a folder to which a case cannot be written (see checkFolderTarget); unless `replace` is
/// set, also a folder that already holds a case.
Result<void> checkCaseTarget(const std::filesystem::path& folder, bool replace);

/// Tells whether `file` is one of the files of the case in `folder`; the file need not exist. Follows links.
bool isCaseFile(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Writes the three files of a case so that 3D Slicer and ITK-SNAP open them directly, with ITK-SNAP's label
/// description beside them. An existing case is replaced as a whole in one step (see writeFolderAtomically); other
/// files in the folder are kept. On failure or cancellation the existing case is unchanged.
Result<void> writeCase(const PatientCase& patient, const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace insonate
