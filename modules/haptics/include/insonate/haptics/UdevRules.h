#pragma once

#include <string>

namespace insonate {

/// Rules for udev that let whoever sits at the computer open the devices of all built-in tables: the contents of
/// packaging/70-insonate.rules.
std::string udevRules();

}  // namespace insonate
