#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace insonate {

/// Name of one number of a label map, from another program.
struct NumberName {
  std::string name;
  std::string snomedCode{};           ///< SNOMED CT code; empty if not stated
  std::optional<LabelColor> color{};  ///< color; no value if not stated
  std::string details{};              ///< ReadStructure::details
};

/// Names of numbers, by number in the label map.
using NumberNames = std::map<std::int32_t, NumberName>;

/// Reads a file that names the numbers of a label map: a label description of ITK-SNAP, a color table of 3D Slicer
/// (.ctbl), a JSON file of dcmqi ("segmentAttributes"), nnU-Net ("labels") or MONAI (channels of a bundle, or a label
/// dictionary). Fails on another kind of file, and on
/// one that names nothing.
Result<NumberNames> readNumberNames(const std::filesystem::path& file);

/// Returns the names in the label table of a NIfTI header extension (Caret's XML, as TotalSegmentator writes it); empty
/// if there are none.
NumberNames namesInExtension(std::string_view text);

}  // namespace insonate
