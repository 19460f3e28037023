#pragma once

#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/MechanicalTable.h>

#include <string>

namespace insonate {

/// All of a table, as a file that parseAcousticTable() and parseMechanicalTable() read back to the last bit. Without
/// ranges and sources.
std::string textOf(const AcousticTable& table);
std::string textOf(const MechanicalTable& table);

}  // namespace insonate
