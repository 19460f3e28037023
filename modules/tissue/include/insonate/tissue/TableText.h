#pragma once

#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/MechanicalTable.h>

#include <string>

namespace insonate {

/// Writes a whole table as JSON text, without ranges and sources. parseAcousticTable() and parseMechanicalTable() read
/// back the identical numbers.
std::string textOf(const AcousticTable& table);
std::string textOf(const MechanicalTable& table);

}  // namespace insonate
