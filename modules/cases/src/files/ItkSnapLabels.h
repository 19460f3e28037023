#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace insonate {

/// ITK-SNAP's label description file: every known label, and others that have a name or occur in the map.
std::string itkSnapLabelText(const PatientCase& patient);

struct ItkSnapLabel {
  std::string name;
  LabelColour colour{};
};

/// Reads labels by their number in the map. Fails on a file of another kind and on an invalid line, with its number.
Result<std::map<std::int32_t, ItkSnapLabel>> readItkSnapLabels(const std::filesystem::path& file);

}  // namespace insonate
