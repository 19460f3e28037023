#pragma once

#include <insonate/core/Result.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace insonate::store {

/// Checks that SQLite and PostgreSQL can store a text byte for byte: UTF-8, without zero bytes, at most `bytes` long.
/// `what` begins the error message: "The reason".
Result<void> checkText(std::string_view what, std::string_view text, std::size_t bytes = 1000);
/// Checks a title or full name: no line breaks, no control characters, and no characters that change the reading
/// direction of surrounding text.
Result<void> checkTitle(std::string_view what, std::string_view text);
/// Checks a name for signing in: 1 to 64 letters, digits and . _ - + @, all letters of one script, so that no two names
/// look the same.
Result<void> checkSignInName(std::string_view name);
Result<void> checkEmail(std::string_view email);
Result<void> checkPassword(std::string_view password);
/// Checks that a text is a JSON object of at most 1 MB, without zero bytes in its strings.
Result<void> checkJsonObject(std::string_view what, std::string_view text);

/// Returns the key by which names are compared; equal for names that differ only in case or in the Unicode encoding of
/// a letter (NFKC, case folding).
std::string nameKey(std::string_view name);

std::string freshUuid();
bool isUuid(std::string_view text);
/// Formats the day of a time since 1970, UTC: "2026-11-22".
std::string dayOf(std::int64_t time_us);
/// Returns the SHA-256 of bytes, hexadecimal.
std::string sha256(std::string_view bytes);

}  // namespace insonate::store
