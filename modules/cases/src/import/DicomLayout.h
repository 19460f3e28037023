#pragma once

#include <filesystem>

namespace insonate {

enum class DicomLayout {
  kNotDicom,
  kCutInHeader,  ///< ends or breaks before its pixels begin
  kCutInPixels,  ///< a readable header, but not all of the pixels it announces
  kWhole,
};

/// Walks a file's elements by their lengths, without interpreting them. Needed before GDCM sees a file: GDCM fills
/// missing pixels silently and aborts the program on some broken headers.
DicomLayout layoutOf(const std::filesystem::path& file);

}  // namespace insonate
