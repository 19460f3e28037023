#pragma once

#include <string>

namespace insonate {

/// Returns the contents of packaging/70-insonate.rules: udev rules that give the logged-in user access to the devices
/// of all built-in device tables.
std::string udevRules();

}  // namespace insonate
