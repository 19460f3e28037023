#pragma once

#include <QCollator>
#include <QLocale>

namespace insonate::ui {

/// Returns the order of people's names in the language of the system: Anna, Änne, Zoë. A system without a language
/// would order by code points; it gets the English order.
inline QCollator nameCollator() {
  QCollator collator(QLocale().language() == QLocale::C ? QLocale(QLocale::English) : QLocale());
  collator.setCaseSensitivity(Qt::CaseInsensitive);
  return collator;
}

}  // namespace insonate::ui
