#pragma once

#include "JsonFields.h"

#include <insonate/tissue/AcousticTable.h>

/// Reads the entries of a tissue file.
namespace insonate::tissuefile {

/// Fills `tissue` from an entry of "tissues". With `complete`, every number has to be there; without, the missing ones
/// stay as they are.
Result<void> readTissue(const nlohmann::json& entry, bool complete, const std::string& where, AcousticTissue& tissue);

/// Inverse of readTissue(), complete.
nlohmann::json written(const AcousticTissue& tissue);

}  // namespace insonate::tissuefile
