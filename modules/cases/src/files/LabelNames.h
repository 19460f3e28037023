#pragma once

#include <insonate/tissue/Labels.h>

#include <optional>
#include <string_view>

namespace insonate {

/// Returns this program's label for a structure's SNOMED CT code, e.g. 12123001 (internal jugular vein); no value if
/// the code is unknown.
std::optional<Label> labelFromSnomed(std::string_view code);

/// Returns this program's label for a structure's usual name ("Left internal jugular vein", "trachea"); no value if the
/// name is unknown, and for a structure that isLeftOut().
std::optional<Label> labelFromAnyName(std::string_view name);

/// Tells whether a structure is known, but has no tissue of this program, e.g. the spleen.
bool isLeftOut(std::string_view name);

}  // namespace insonate
