#pragma once

#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/MechanicalTable.h>

#include <string>

namespace insonate {

/// Writes a whole table as JSON text, without the ranges and sources of its values. parseAcousticTable() and
/// parseMechanicalTable() read exactly the same numbers from this text.
std::string textOf(const AcousticTable& table);
std::string textOf(const MechanicalTable& table);

}  // namespace insonate
