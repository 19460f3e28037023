#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Header entries of a written series. The UIDs are derived from `seed` alone: same seed, same bytes.
struct DicomSeriesIdentity {
  std::string seed;  ///< e.g. the phantom's variant and random seed
  std::string patientName = "PHANTOM^NECK";
  std::string patientId = "PHANTOM";
  std::string description = {};  ///< Series Description, at most 64 characters of ASCII
};

/// Refuses, before any work, a folder that a series could not be written to (see checkFolderTarget) or that is not
/// empty.
Result<void> checkDicomTarget(const std::filesystem::path& folder);

/// Writes one file a slice (Part 10, CT Image Storage, explicit VR little endian, HU stored as they are) into a folder
/// that is created, or exists and is empty. importSeries reads back the same HU (from -1024 up) and the same places;
/// a left-handed grid comes back with its slices in the opposite order, which is right-handed. Positions keep the 16
/// characters that DICOM allows a number. Nothing is left behind on failure.
Result<void> writeDicomSeries(const CtVolume& ct, const std::filesystem::path& folder,
                              const DicomSeriesIdentity& identity, const Progress& progress = {});

}  // namespace insonate
