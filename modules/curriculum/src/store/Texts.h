#pragma once

#include <insonate/core/Result.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace insonate::store {

/// A text that both databases keep byte for byte: UTF-8, without zero bytes, at most `bytes` long. `what` begins the
/// sentence: "The reason".
Result<void> checkText(std::string_view what, std::string_view text, std::size_t bytes = 1000);
/// Checks a title or full name: no line breaks or controls, nothing that turns the reading direction of surrounding
/// text.
Result<void> checkTitle(std::string_view what, std::string_view text);
/// Checks a name for signing in: 1..64 letters, digits and . _ - + @, the letters of one script, so that no name looks
/// like another.
Result<void> checkSignInName(std::string_view name);
Result<void> checkEmail(std::string_view email);
Result<void> checkPassword(std::string_view password);
/// A JSON object of at most 1 MB, without zero bytes in its texts either.
Result<void> checkJsonObject(std::string_view what, std::string_view text);

/// The common form of names that differ only in case or in Unicode's ways of writing one letter (NFKC, case folding).
std::string nameKey(std::string_view name);

std::string freshUuid();
bool isUuid(std::string_view text);
/// Formats the day of a time since 1970, UTC: "2026-11-22".
std::string dayOf(std::int64_t time_us);
/// Hexadecimal.
std::string sha256(std::string_view bytes);

}  // namespace insonate::store
