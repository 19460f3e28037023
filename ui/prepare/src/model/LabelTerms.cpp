#include "LabelTerms.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QCoreApplication>

namespace insonate::prepare {

QString stateWord(LabelState state) {
  return QCoreApplication::translate("LabelTerms", std::string(nameOf(state)).c_str());
}

QIcon stateIcon(LabelState state) {
  constexpr const char* kIcons[] = {"state-none", "state-begun", "done", "flag"};
  return ui::icon(QLatin1String(kIcons[std::size_t(state)]), ui::colorOf(state));
}

QString termOf(std::uint8_t tissue) {
  const LabelInfo& info = labelTable()[knownLabel(tissue)];
  return QStringLiteral("SNOMED CT %1, %2").arg(ui::qt(info.snomedCode), ui::qt(info.snomedMeaning));
}

}  // namespace insonate::prepare
