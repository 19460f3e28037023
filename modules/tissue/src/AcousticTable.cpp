#include "TableFile.h"
#include "TissueFields.h"

#include <insonate/embedded/tissues.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/TableText.h>

namespace insonate {
namespace {

const tissuefile::TableForm<AcousticTable>& acousticForm() {
  static const tissuefile::TableForm<AcousticTable> all{"tissue", presetsOf(embedded::tissues::files()),
                                                        tissuefile::readTissue};
  return all;
}

}  // namespace

std::vector<std::string> acousticPresetNames() {
  return namesOf(acousticForm().presets);
}

Result<AcousticTable> parseAcousticTable(std::string_view text) {
  return tissuefile::parseTable(text, acousticForm());
}

Result<AcousticTable> loadAcousticTable(std::string_view nameOrPath) {
  return tissuefile::loadTable(nameOrPath, acousticForm());
}

std::string textOf(const AcousticTable& table) {
  return tissuefile::tableText(table, tissuefile::written);
}

}  // namespace insonate
