#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Returns the word in `known` that is most similar to `word`, for a question such as "did you mean 'depth'?"; empty if
/// no word is similar. A word that differs only by an appended unit ("depth_mm" for "depth") is the best match.
std::string_view nearestWord(std::string_view word, const std::vector<std::string_view>& known);

/// Joins words with commas: "a, b, c".
std::string joinedWords(const std::vector<std::string_view>& words);

/// Quotes and joins names that may contain commas or spaces: "'a', 'b', 'c'".
std::string quotedWords(const std::vector<std::string_view>& words);

/// Returns the text for HTML, XML and SVG, also within quoted attributes; control characters that XML forbids are
/// removed.
std::string escapedMarkup(std::string_view text);

/// Rewrites the message of an exception of the JSON parser for users: "line 1, column 2: ...", without names of the
/// library.
std::string readableJsonError(std::string_view what);

}  // namespace insonate
