#pragma once

#include <insonate/cases/VesselName.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

enum class Digits { kSeparate, kKeep };

/// Returns the words of a name in lower case without accents; "sous-clavière" becomes one word. Digits separate words,
/// or belong to them.
std::vector<std::string> foldedWords(std::string_view name, Digits digits = Digits::kSeparate);

/// Tells whether a word means right or left in English, German, French, Spanish or Latin.
bool isSideWord(std::string_view word, BodySide side);

/// Returns the side that a name states, as a word anywhere or as the letter R or L at its beginning or end; no value if
/// it states none or both.
std::optional<BodySide> sideInName(std::string_view name);

/// Returns the words of a name without the side and without words that contain a digit, separated by spaces, e.g.
/// "rib" for "rib_left_4".
std::string nameWithoutSide(std::string_view name);

}  // namespace insonate
