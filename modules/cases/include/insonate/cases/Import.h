#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// One importable image stack, without anything that identifies the patient except `uid`, which never enters a case.
struct SeriesInfo {
  std::string uid;       ///< names the series for importSeries: DICOM Series Instance UID, with "#2" when one UID holds
                         ///< several stacks; the file's name for NRRD, NIfTI and MetaImage
  std::string modality;  ///< as in DICOM ("CT", "MR", ...); empty when the file does not say
  std::string kernel;  ///< of the reconstruction, in the scanner's own word, which never enters a case; empty when the
                       ///< slices do not say, or not the same
  VolumeGeometry geometry;    ///< the orthogonal grid that an import produces, patient LPS mm
  bool geometryKnown = true;  ///< false for a refused series that does not say; only the size is meaningful then
  std::vector<std::string> warnings;  ///< a sentence each, without names of files
  std::string refusal;                ///< why it cannot be imported; empty when it can
};

/// A file that is in no series, and why.
struct SetAside {
  std::filesystem::path file;
  std::string reason;
};

struct SeriesListing {
  std::vector<SeriesInfo> series;
  std::vector<SetAside> setAside;
};

/// Result of an import. `ct` is int16 HU; padding and everything below -1024 are set to -1024.
struct ImportedCt {
  CtVolume ct;
  SeriesInfo series;   ///< its warnings say everything that was changed on the way: for CaseManifest::importNotes
  std::string source;  ///< for CaseManifest::source; holds a one-way hash of the UID, no names, dates or file names
  /// Offset that seems to be missing for conversion to HU, for shiftValues(); -1024 if air lies at 0 and soft tissue
  /// above 1000. Never applied without a request. Empty if the values look right, or match no known pattern.
  std::optional<int> likelyShift_HU{};
};

/// Lists what a folder (searched with its subfolders) or a single file holds, from the headers only. A DICOM slice
/// stands for its series, as far as that lies in the same folder, and a DICOM directory (DICOMDIR) for its folder.
/// Fails when the input does not exist, cannot be read, or holds no series at all.
Result<SeriesListing> listSeries(const std::filesystem::path& input, const Progress& progress = {});

/// Reads one series as HU. DICOM slices are placed by their own position and orientation only: gantry tilt, uneven
/// spacing and small gaps are resampled onto an orthogonal grid and said so; large gaps are refused.
/// `uid` may be empty when there is exactly one importable series; otherwise fails with the list. Files that cannot be
/// opened may be slices of it: without `uid` they are an error, with it a warning. A volume file that holds but a few
/// different numbers, none below 0, is a label map and refused.
/// Blocking; `progress` is called on the calling thread.
Result<ImportedCt> importSeries(const std::filesystem::path& input, const std::string& uid = {},
                                const Progress& progress = {});

/// Adds to every value but padding (-1024), limited to -1024..32767 HU, and says so in the warnings.
void shiftValues(ImportedCt& imported, int shift_HU);

/// The list as lines of text, e.g. for the error of an ambiguous import.
std::string describe(const SeriesListing& listing);

}  // namespace insonate
