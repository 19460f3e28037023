#pragma once

#include <QCoreApplication>
#include <QString>
#include <string_view>

namespace insonate {

/// Translates a text in a function that belongs to no QObject.
inline QString tr(const char* text) {
  return QCoreApplication::translate("insonate", text);
}

}  // namespace insonate

namespace insonate::ui {

/// Converts UTF-8, which all modules without Qt use, to a QString.
inline QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), int(text.size()));
}

}  // namespace insonate::ui
