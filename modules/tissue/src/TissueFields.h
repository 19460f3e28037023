#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <nlohmann/json.hpp>

#include <string>

/// Reads the entries of a tissue file. `where` opens each sentence: "tissue 'fat'".
namespace insonate::tissuefile {

/// Fills `tissue` from an entry of "tissues". With `complete`, every number has to be there; without, the missing ones
/// stay as they are.
Result<void> readTissue(const nlohmann::json& entry, bool complete, const std::string& where, AcousticTissue& tissue);

/// The entry's "label": a name or number of insonate/tissue/Labels.h.
Result<Label> readLabel(const nlohmann::json& entry);

/// Refuses anything but an object with known keys.
Result<void> checkKeys(const nlohmann::json& object, const std::vector<std::string_view>& known,
                       const std::string& where);

}  // namespace insonate::tissuefile
