#pragma once

#include <insonate/cases/PatientCase.h>

#include <string>

namespace insonate {

/// ITK-SNAP's label description file: every known label, and unknown ones that occur in the map.
std::string itkSnapLabelText(const LabelMap& labels, const LabelColours& colours);

}  // namespace insonate
