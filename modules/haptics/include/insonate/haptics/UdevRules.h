#pragma once

#include <string>

namespace insonate {

/// Returns udev rules that let the logged-in user access the devices of all built-in device tables: the contents of
/// packaging/70-insonate.rules.
std::string udevRules();

}  // namespace insonate
