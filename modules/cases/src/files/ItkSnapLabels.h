#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace insonate {

/// Returns the text of ITK-SNAP's label description file: every known label, and other labels that have a name or occur
/// in the map.
std::string itkSnapLabelText(const PatientCase& patient);

struct ItkSnapLabel {
  std::string name;
  LabelColor color{};
};

/// Reads an ITK-SNAP label description: names and colors by number in the map. Fails on another kind of file, and on an
/// invalid line, with the line's number.
Result<std::map<std::int32_t, ItkSnapLabel>> readItkSnapLabels(const std::filesystem::path& file);

}  // namespace insonate
