#include "MechanicalFields.h"
#include "TableFile.h"

#include <insonate/embedded/mechanics.h>
#include <insonate/tissue/MechanicalTable.h>
#include <insonate/tissue/TableText.h>

namespace insonate {
namespace {

const tissuefile::TableForm<MechanicalTable>& form() {
  static const tissuefile::TableForm<MechanicalTable> all{"mechanics", presetsOf(embedded::mechanics::files()),
                                                          tissuefile::readMechanics};
  return all;
}

}  // namespace

std::vector<std::string> mechanicalPresetNames() {
  const auto names = form().names();
  return {names.begin(), names.end()};
}

Result<MechanicalTable> parseMechanicalTable(std::string_view text) {
  return tissuefile::parseTable(text, form());
}

Result<MechanicalTable> loadMechanicalTable(std::string_view nameOrPath) {
  return tissuefile::loadTable(nameOrPath, form());
}

std::string textOf(const MechanicalTable& table) {
  return tissuefile::tableText(table, tissuefile::written);
}

}  // namespace insonate
