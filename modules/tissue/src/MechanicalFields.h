#pragma once

#include <insonate/tissue/MechanicalTable.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

/// Reads the entries of a mechanics file.
namespace insonate::tissuefile {

/// Fills `tissue` from an entry of "tissues". Every number of its kind has to be there with `complete`, and where the
/// entry makes it another kind; else the missing ones stay as they are. A number of another kind is refused.
void readMechanics(const nlohmann::json& object, bool complete, const std::string& where, std::string& trouble,
                   MechanicalTissue& tissue);

/// Inverse of readMechanics(), complete.
nlohmann::json written(const MechanicalTissue& tissue);

}  // namespace insonate::tissuefile
