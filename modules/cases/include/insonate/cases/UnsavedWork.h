#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Checksums that identify the volumes of a case.
struct CaseSums {
  std::array<int, 3> size{};  ///< voxels along i, j, k
  std::uint32_t ct = 0, labels = 0;
  bool operator==(const CaseSums&) const = default;
  /// Tells whether both cases have the same CT.
  bool hasSameCt(const CaseSums& other) const { return size == other.size && ct == other.ct; }
};

/// Takes some tenths of a second for a large CT.
CaseSums sumsOf(const PatientCase& patient);

/// Runs of voxels whose label differs between two label maps, with their new label; packed as bytes of variable-length
/// numbers.
using LabelRuns = std::vector<std::uint8_t>;

/// Returns the runs that change `from` to `to`, which must be on one grid. An empty `from` stands for a map of
/// background.
LabelRuns runsBetween(const std::vector<std::uint8_t>& from, const std::vector<std::uint8_t>& to);
/// Sets the voxels of the runs. Fails, possibly after a part of the changes, if the runs do not fit the map.
Result<void> applyRuns(const LabelRuns& runs, std::vector<std::uint8_t>& labels);

/// Changes of a case that are not saved in its folder, with everything that is needed to apply them to the case again.
struct UnsavedWork {
  std::string folder;         ///< folder of the case; empty if the case was never saved
  std::int64_t time_s = 0;    ///< time of the last change, in seconds since 1970 UTC
  int strokes = 0;            ///< number of unsaved brush strokes
  int steps = 0;              ///< number of other unsaved labeling steps
  std::string recipe;         ///< text of the unsaved labeling steps as a recipe; empty if there are none
  CaseSums sums;              ///< the case without the changes
  bool hasAllLabels = false;  ///< true: the runs contain all labels, not only changes
  LabelRuns runs;
  CaseManifest before, after;  ///< manifest without and with the changes
  LabelColors colorsBefore, colorsAfter;
};

/// Parts of a case that an UnsavedWork changes.
struct UnsavedParts {
  bool labels = false, title = false, places = false, terms = false, colors = false, shown = false;
};
UnsavedParts partsOf(const UnsavedWork& work);

/// Tells whether manifest and colors are still those to which the work belongs.
bool isUnchanged(const UnsavedWork& work, const CaseManifest& manifest, const LabelColors& colors);

/// Applies the changes of manifest and colors. If the case was saved again meanwhile, only fields that the work changes
/// are replaced.
void applyValues(const UnsavedWork& work, CaseManifest& manifest, LabelColors& colors);
/// Returns the labels with the changes applied. Fails if the changes do not fit the map.
Result<LabelMap> withUnsavedLabels(const UnsavedWork& work, const LabelMap& labels);

/// Writes the work to a file through a temporary file that then replaces it. On failure the former file is unchanged.
Result<void> writeUnsavedWork(const UnsavedWork& work, const std::filesystem::path& file);
/// Reads the work. Fails with a sentence on a file that is cut, damaged or written by a newer program.
Result<UnsavedWork> readUnsavedWork(const std::filesystem::path& file);

}  // namespace insonate
