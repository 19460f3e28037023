#pragma once

#include "JsonFields.h"

#include <insonate/tissue/MechanicalTable.h>

/// Reads the entries of a mechanics file.
namespace insonate::tissuefile {

/// Fills `tissue` from an entry of "tissues". Every number of its kind has to be there with `complete`, and where the
/// entry makes it another kind; else the missing ones stay as they are. A number of another kind is refused.
Result<void> readMechanics(const nlohmann::json& entry, bool complete, const std::string& where,
                           MechanicalTissue& tissue);

/// Inverse of readMechanics(), complete.
nlohmann::json written(const MechanicalTissue& tissue);

}  // namespace insonate::tissuefile
