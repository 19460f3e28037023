#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Header entries of a DICOM series that the program writes. All UIDs are derived from `seed`, so that the same seed
/// gives the same bytes.
struct DicomSeriesIdentity {
  std::string seed;  ///< text from which all UIDs are derived, e.g. the phantom's variant and random seed
  std::string patientName = "PHANTOM^NECK";
  std::string patientId = "PHANTOM";
  std::string description = {};  ///< Series Description, at most 64 characters of ASCII
};

/// Refuses, before any work, a folder to which a series cannot be written (see checkFolderTarget) or that is not empty.
Result<void> checkDicomTarget(const std::filesystem::path& folder);

/// Writes one file per slice (Part 10, CT Image Storage, explicit VR little endian, unscaled HU) into a folder, which
/// is created or must be empty. importSeries() reads the same HU (from -1024 up) at the same positions from these
/// files. The slices of a left-handed grid are read in the opposite order, which makes the grid right-handed. Positions
/// are rounded to the 16 characters that DICOM allows for a number. On failure all written files are removed.
Result<void> writeDicomSeries(const CtVolume& ct, const std::filesystem::path& folder,
                              const DicomSeriesIdentity& identity, const Progress& progress = {});

}  // namespace insonate
