#pragma once

#include <filesystem>

namespace insonate {

enum class DicomLayout {
  kNotDicom,
  kCutInHeader,  ///< the file ends or is damaged before its pixels begin
  kCutInPixels,  ///< the header is readable, but the file has fewer pixels than the header declares
  kWhole,
};

/// Checks the lengths of a file's elements, without interpreting the elements, before GDCM reads the file: GDCM
/// silently fills missing pixels and aborts the program on some broken headers.
DicomLayout layoutOf(const std::filesystem::path& file);

}  // namespace insonate
