#include "MechanicalFields.h"
#include "TableFile.h"

#include <insonate/embedded/mechanics.h>
#include <insonate/tissue/MechanicalTable.h>
#include <insonate/tissue/TableText.h>

namespace insonate {
namespace {

const tissuefile::TableForm<MechanicalTable>& mechanicalForm() {
  static const tissuefile::TableForm<MechanicalTable> all{"mechanics", presetsOf(embedded::mechanics::files()),
                                                          tissuefile::readMechanics};
  return all;
}

}  // namespace

std::vector<std::string> mechanicalPresetNames() {
  return namesOf(mechanicalForm().presets);
}

Result<MechanicalTable> parseMechanicalTable(std::string_view text) {
  return tissuefile::parseTable(text, mechanicalForm());
}

Result<MechanicalTable> loadMechanicalTable(std::string_view nameOrPath) {
  return tissuefile::loadTable(nameOrPath, mechanicalForm());
}

std::string textOf(const MechanicalTable& table) {
  return tissuefile::tableText(table, tissuefile::written);
}

}  // namespace insonate
