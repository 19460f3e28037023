#pragma once

#include <insonate/image/Volume.h>

#include <string>

namespace insonate {

/// ITK-SNAP's label description file: every known label, and unknown ones that occur in the map.
std::string itkSnapLabelText(const LabelMap& labels);

}  // namespace insonate
