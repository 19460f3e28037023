#include <insonate/core/Words.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace insonate {
namespace {

/// Levenshtein distance, ignoring case.
int editDistance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (const char left : a) {
    int diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = diagonal + (lower(left) != lower(b[j]));
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearestWord(std::string_view word, const std::vector<std::string_view>& known) {
  std::string_view best;
  int bestDistance = 1 + static_cast<int>(std::min<std::size_t>(word.size(), 40)) / 2;
  for (const std::string_view candidate : known) {
    const bool withoutUnit = !word.empty() && candidate.size() > word.size() && candidate[word.size()] == '_' &&
                             editDistance(word, candidate.substr(0, word.size())) == 0;
    const int distance = withoutUnit ? 0 : editDistance(word, candidate);
    if (distance < bestDistance) best = candidate, bestDistance = distance;
  }
  return best;
}

std::string joinedWords(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

std::string quotedWords(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "'" : ", '") + std::string(word) + "'";
  return text;
}

std::string escapedMarkup(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\r' || c == '\t') safe += c;
    }
  }
  return safe;
}

std::string readableJsonError(std::string_view what) {
  if (what.starts_with("[json.exception"))
    if (const std::size_t tag = what.find("] "); tag != what.npos) what.remove_prefix(tag + 2);
  constexpr std::string_view kPlace = "parse error at ";
  if (what.starts_with(kPlace)) what.remove_prefix(kPlace.size());
  return std::string(what);
}

}  // namespace insonate
