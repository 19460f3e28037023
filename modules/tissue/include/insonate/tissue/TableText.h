#pragma once

#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/MechanicalTable.h>

#include <string>

namespace insonate {

/// Writes a whole table as a file that parseAcousticTable() and parseMechanicalTable() read back to the last bit,
/// without ranges and sources.
std::string textOf(const AcousticTable& table);
std::string textOf(const MechanicalTable& table);

}  // namespace insonate
