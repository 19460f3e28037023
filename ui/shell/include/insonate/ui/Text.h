#pragma once

#include <QString>
#include <string_view>

namespace insonate::ui {

/// UTF-8 as everything below the window has it.
inline QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), int(text.size()));
}

}  // namespace insonate::ui
