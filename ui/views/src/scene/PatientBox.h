#pragma once

#include "Structure.h"

#include <map>

namespace insonate::views {

/// The box of all surfaces, hidden ones too, or without any of the CT; VTK's order: x low, x high, ... False for
/// nothing.
bool patientBox(const std::map<std::uint8_t, Structure>& structures, const VtkCase* patient, double box[6]);

/// The CT's box.
void ctBox(const VtkCase& patient, double box[6]);

}  // namespace insonate::views
