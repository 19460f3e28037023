#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Returns the known word most similar to `word`, for "did you mean"; empty if none is similar. A known word that
/// differs only by an appended unit ("depth_mm" for "depth") is the best match.
std::string_view nearestWord(std::string_view word, const std::vector<std::string_view>& known);

/// Joins words with commas: "a, b, c".
std::string joinedWords(const std::vector<std::string_view>& words);

/// Quotes and joins names that may contain commas or spaces: "'a', 'b', 'c'".
std::string quotedWords(const std::vector<std::string_view>& words);

/// Rewrites the text of a JSON parser's exception for users: "line 1, column 2: ..." without the library's names.
std::string jsonProblem(std::string_view what);

}  // namespace insonate
