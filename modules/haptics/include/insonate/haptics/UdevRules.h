#pragma once

#include <string>

namespace insonate {

/// Rules for udev that give the user at the computer access to the devices of all built-in tables: the contents of
/// packaging/70-insonate.rules.
std::string udevRules();

}  // namespace insonate
