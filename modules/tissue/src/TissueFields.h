#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

/// Reads the entries of a tissue file.
namespace insonate::tissuefile {

/// Fills `tissue` from an entry of "tissues". With `complete`, every number has to be there; without, the missing ones
/// stay as they are.
void readTissue(const nlohmann::json& object, bool complete, const std::string& where, std::string& trouble,
                AcousticTissue& tissue);

/// Inverse of readTissue(), complete.
nlohmann::json written(const AcousticTissue& tissue);

}  // namespace insonate::tissuefile
