#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// The known word most like `word`, for "did you mean"; empty when none resembles it. A name without its unit
/// ("depth" for "depth_mm") counts as the most alike.
std::string_view nearestWord(std::string_view word, const std::vector<std::string_view>& known);

/// "a, b, c"
std::string joinedWords(const std::vector<std::string_view>& words);

/// "'a', 'b', 'c'", for names that may hold commas or spaces.
std::string quotedWords(const std::vector<std::string_view>& words);

/// Rewrites the text of a JSON parser's exception for users: "line 1, column 2: ..." without the library's names.
std::string jsonProblem(std::string_view what);

}  // namespace insonate
