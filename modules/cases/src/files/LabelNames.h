#pragma once

#include <insonate/tissue/Labels.h>

#include <optional>
#include <string_view>

namespace insonate {

/// This program's label for a SNOMED CT code of a structure that it knows, e.g. 12123001 (internal jugular vein).
std::optional<Label> labelFromSnomed(std::string_view code);

/// This program's label for a structure's name as people write it ("Left internal jugular vein", "trachea").
std::optional<Label> labelFromAnyName(std::string_view name);

}  // namespace insonate
