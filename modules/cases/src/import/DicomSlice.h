#pragma once

#include <insonate/core/Vec3.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Properties of one slice that an import needs. A slice is a CT file, or one frame of an enhanced CT file.
struct DicomSlice {
  std::filesystem::path file;
  int frame = 0;
  std::string studyUid, seriesUid, sopUid, frameOfReferenceUid, modality;
  std::optional<int> acquisition, instance;
  int columns = 0, rows = 0;
  std::optional<Vec3> position_mm;                 ///< center of the slice's first pixel, patient LPS
  std::optional<std::array<Vec3, 2>> orientation;  ///< patient directions along a row (i) and down a column (j)
  /// Pixel spacing as in DICOM: distance between rows, then between columns.
  std::optional<std::array<double, 2>> pixelSpacing_mm;
  std::optional<double> thickness_mm;
  std::optional<double> slope, intercept;
  bool lookupTable = false;  ///< true if values are converted by a lookup table instead of slope and intercept
  std::string kernel;        ///< reconstruction kernel, as the scanner names it
  std::string description, date, bodyPart;    ///< description, date and body part, as in SeriesInfo
  std::optional<std::array<int, 2>> padding;  ///< stored values from..to that mean "no image here"
  bool burnedInText = false;
  bool lossy = false;      ///< true if the image has been compressed with loss
  bool otherUnit = false;  ///< true if values are in another unit than Hounsfield units, or in an unspecified unit
  bool cutOff = false;     ///< true if the file ends before the slice's last pixel
};

/// The slices of a file, or the reason why it has none.
struct DicomScan {
  std::vector<DicomSlice> slices;
  std::string skippedFiles;
  bool isDirectory = false;  ///< true if the file is an index of the images in the folders beside it (DICOMDIR)
};

/// Reads a file's header. Sets aside scouts, screenshots, segmentations, reports, indexes and files other than DICOM;
/// returns images of other modalities as slices, so that they can be listed.
DicomScan scanDicom(const std::filesystem::path& file);

}  // namespace insonate
