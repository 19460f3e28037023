#pragma once

#include <insonate/cases/LabelFile.h>
#include <insonate/tissue/Labels.h>

#include <optional>
#include <string>
#include <string_view>

namespace insonate {

/// Returns this program's label for a structure's SNOMED CT code, e.g. 12123001 (internal jugular vein); no value if
/// the code is unknown.
std::optional<Label> labelFromSnomed(std::string_view code);

/// Returns this program's label for a structure's usual name ("Left internal jugular vein", "trachea"); no value if the
/// name is unknown, and for a structure that isLeftOut().
std::optional<Label> labelFromAnyName(std::string_view name);

/// Returns the name in the table of structures (ReadStructure::known) for a name and a SNOMED CT code, of which the
/// name is often more exact: "ACC rechts" with the code of "Carotid artery". Empty if neither is in the table.
std::string knownStructure(std::string_view name, std::string_view code);

/// Tells whether an import reads a structure: as the author has chosen, else `otherwise`.
bool isTaken(const ReadStructure& structure, const StructureChoices& choices, bool otherwise);

/// Tells whether a structure is known, but has no tissue of this program, e.g. the spleen.
bool isLeftOut(std::string_view name);

}  // namespace insonate
