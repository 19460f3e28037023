#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// A series: one stack of images, which can be imported unless `refusal` says why not. Contains no data that identify
/// the patient, except `uid`, which is never stored in a case.
struct SeriesInfo {
  std::string uid;  ///< identifies the series for importSeries(): DICOM Series Instance UID, with "#2" if one UID holds
                    ///< several stacks; file name for NRRD, NIfTI and MetaImage
  std::string modality;  ///< imaging modality as in DICOM ("CT", "MR", ...); empty if the file does not specify it
  std::string kernel;  ///< reconstruction kernel, as the scanner names it; never stored in a case; empty if missing or
                       ///< different between slices
  VolumeGeometry geometry;            ///< the orthogonal grid that an import produces, patient LPS mm
  bool geometryKnown = true;          ///< false: the geometry of a refused series is unknown; only its size is valid
  std::vector<std::string> warnings;  ///< warnings about the series, one sentence each, without file names
  std::string refusal;                ///< reason why the series cannot be imported; empty if it can
  /// Description, date ("2026-11-24") and body part as the scanner states them, to recognize the series in a list;
  /// never stored in a case. Empty if missing or different between slices.
  std::string description{}, date{}, bodyPart{};
};

/// A file that belongs to no series, with the reason why it does not.
struct SkippedFile {
  std::filesystem::path file;
  std::string reason;
};

struct SeriesListing {
  std::vector<SeriesInfo> series;
  std::vector<SkippedFile> skippedFiles;
};

/// Result of an import. `ct` is int16 HU, in which padding and all values below -1024 are set to -1024.
struct ImportedCt {
  CtVolume ct;
  SeriesInfo series;   ///< the imported series; its warnings list all changes made during the import, for
                       ///< CaseManifest::importNotes
  std::string source;  ///< origin of the CT, for CaseManifest::source; contains a one-way hash of the UID, no names,
                       ///< dates or file names
  /// Offset that the conversion to HU in the file probably lacks, for shiftValues(): -1024 if air is at 0 and soft
  /// tissue above 1000. The import does not apply the offset. No value if the HU are plausible or match no known
  /// pattern.
  std::optional<int> likelyShift_HU{};
  /// Number of voxels whose values, scaled as the file states, exceed the maximum of a case; they were limited to 32767
  /// HU. If above 0, the scale is probably wrong: ask the user before making a case.
  std::size_t saturatedVoxels = 0;
};

/// Lists the series in a folder (with its subfolders) or in a single file; reads headers only. For a single DICOM
/// slice, lists its series within the same folder; for a DICOM directory (DICOMDIR), all series of its folder. Fails if
/// the input does not exist, cannot be read, or holds no series.
Result<SeriesListing> listSeries(const std::filesystem::path& input, const Progress& progress = {});

/// Reads one series as HU. DICOM slices are placed only by their own position and orientation. Gantry tilt, uneven
/// spacing and small gaps are resampled onto an orthogonal grid, with a warning; large gaps are refused. `uid` may be
/// empty if there is exactly one importable series; otherwise the error lists the series. Files that cannot be opened
/// may be slices of the series: they cause an error if `uid` is empty, else a warning. A volume file with only a few
/// different values, none below 0, is regarded as a label map and refused. The call blocks; `progress` is called on the
/// calling thread.
Result<ImportedCt> importSeries(const std::filesystem::path& input, const std::string& uid = {},
                                const Progress& progress = {});

/// Adds `shift_HU` to every value except padding (-1024), limits the result to -1024 to 32767 HU, and adds a warning.
void shiftValues(ImportedCt& imported, int shift_HU);

/// Returns the sentence that asks whether a CT with saturated voxels shall be imported.
std::string saturationText(const ImportedCt& imported);

/// A selection from a listing that a user can survey.
struct ListingOverview {
  std::vector<std::size_t> shown;    ///< indices into SeriesListing::series, in the listing's order
  std::vector<std::string> omitted;  ///< one sentence for each group of stacks that are not shown
};

/// Selects the series to show. Of many stacks that differ only in position, e.g. slices that form no common stack, only
/// the first ones are shown.
ListingOverview overviewOf(const SeriesListing& listing);

/// Writes the overview of a listing as lines of text, e.g. for the error of an ambiguous import.
std::string seriesListText(const SeriesListing& listing);

}  // namespace insonate
