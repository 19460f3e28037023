#include "LabelTerms.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QCoreApplication>

namespace insonate::prepare {

QString stateWord(LabelState state) {
  return QCoreApplication::translate("LabelTerms", std::string(nameOf(state)).c_str());
}

QIcon stateIcon(LabelState state) {
  switch (state) {
    case LabelState::InProgress:
      return ui::icon(QStringLiteral("state-begun"));
    case LabelState::Completed:
      return ui::icon(QStringLiteral("done"), views::theme::kGood);
    case LabelState::Flagged:
      return ui::icon(QStringLiteral("flag"), views::theme::kCaution);
    default:
      return ui::icon(QStringLiteral("state-none"), views::theme::kQuiet);
  }
}

QString termOf(std::uint8_t tissue) {
  const LabelInfo& info = labelTable()[knownLabel(tissue)];
  return QStringLiteral("SNOMED CT %1, %2").arg(ui::qt(info.snomedCode), ui::qt(info.snomedMeaning));
}

}  // namespace insonate::prepare
