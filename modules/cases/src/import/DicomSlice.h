#pragma once

#include <insonate/core/Vec3.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Properties of one slice that an import needs: a CT file, or one frame of an enhanced CT file.
struct DicomSlice {
  std::filesystem::path file;
  int frame = 0;
  std::string studyUid, seriesUid, sopUid, frameOfReferenceUid, modality;
  std::optional<int> acquisition, instance;
  int columns = 0, rows = 0;
  std::optional<Vec3> position_mm;                       ///< center of the first pixel, patient LPS
  std::optional<std::array<Vec3, 2>> orientation;        ///< patient directions along a row (i) and down a column (j)
  std::optional<std::array<double, 2>> pixelSpacing_mm;  ///< as in DICOM: between rows, then between columns
  std::optional<double> thickness_mm;
  std::optional<double> slope, intercept;
  bool lookupTable = false;                   ///< its values go through a table instead
  std::string kernel;                         ///< of the reconstruction
  std::optional<std::array<int, 2>> padding;  ///< stored values from..to that mean "no image here"
  bool burnedInText = false;
  bool lossy = false;      ///< was compressed with loss at some time
  bool otherUnit = false;  ///< says that its values are something else than Hounsfield units, or does not say what
  bool cutOff = false;     ///< its pixels are incomplete
};

/// The slices of a file, or why it has none.
struct DicomScan {
  std::vector<DicomSlice> slices;
  std::string setAside;
  bool isDirectory = false;  ///< an index of the images in the folders beside it (DICOMDIR)
};

/// Reads a file's header. Scouts, screenshots, segmentations, reports, indexes and files that are no DICOM are set
/// aside; images of other modalities are returned as slices, for the list.
DicomScan scanDicom(const std::filesystem::path& file);

}  // namespace insonate
