#pragma once

#include <algorithm>
#include <string_view>

namespace insonate {

/// Tells whether a text is a valid name of a curriculum, level or form. These names become parts of web addresses and
/// file names.
inline bool isPlainName(std::string_view name) {
  const auto plain = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  };
  return !name.empty() && name.size() <= 64 && std::ranges::all_of(name, plain);
}

inline constexpr const char* kPlainNameSentence =
    "needs a 'name' (short name) of at most 64 letters (a to z), digits, '_', '-' and '.'; the 'title' may have any.";

}  // namespace insonate
