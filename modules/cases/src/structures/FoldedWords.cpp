#include "FoldedWords.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace insonate {
namespace {

struct SideWords {
  BodySide side;
  std::vector<std::string_view> words;  ///< whole words
};

const std::array<SideWords, 2> kSides{
    {{BodySide::Right,
      {"right", "rt", "rechts", "rechte", "rechter", "rechtes", "rechten", "re", "droit", "droite", "derecha",
       "derecho", "dcha", "dcho", "dexter", "dextra", "dextrum", "dextrae"}},
     {BodySide::Left,
      {"left", "lt", "links", "linke", "linker", "linkes", "linken", "li", "gauche", "izquierda", "izquierdo", "izda",
       "izdo", "sinister", "sinistra", "sinistrum", "sinistrae"}}}};

/// Base letter of a Latin-1 letter in UTF-8, by its second byte after 0xC3.
std::string_view baseLetter(unsigned char second) {
  const unsigned char letter = second | 0x20;  // lower case
  if (letter >= 0xA0 && letter <= 0xA5) return "a";
  if (letter == 0xA7) return "c";
  if (letter >= 0xA8 && letter <= 0xAB) return "e";
  if (letter >= 0xAC && letter <= 0xAF) return "i";
  if (letter == 0xB1) return "n";
  if (letter >= 0xB2 && letter <= 0xB6) return "o";
  if (letter >= 0xB9 && letter <= 0xBC) return "u";
  return second == 0x9F ? "ss" : " ";
}

bool hasDigit(const std::string& word) {
  return std::ranges::any_of(word, [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::optional<BodySide> sideOfWord(std::string_view word, bool isAtEnd) {
  for (const BodySide side : {BodySide::Right, BodySide::Left})
    if (isSideWord(word, side) || (isAtEnd && word == (side == BodySide::Right ? "r" : "l"))) return side;
  return std::nullopt;
}

/// Side of each word of a name. A letter alone is a side only at an end of the name, and is not a whole name.
std::vector<std::optional<BodySide>> sidesOf(const std::vector<std::string>& words) {
  std::vector<std::optional<BodySide>> sides;
  for (std::size_t n = 0; n < words.size(); ++n)
    sides.push_back(sideOfWord(words[n], words.size() > 1 && (n == 0 || n + 1 == words.size())));
  return sides;
}

}  // namespace

std::vector<std::string> foldedWords(std::string_view name, Digits digits) {
  std::string text;
  for (std::size_t n = 0; n < name.size(); ++n) {
    const auto c = static_cast<unsigned char>(name[n]);
    const auto next = n + 1 < name.size() ? static_cast<unsigned char>(name[n + 1]) : 0;
    if (c == 0xC3 && next >= 0x80)
      text += baseLetter(static_cast<unsigned char>(next)), ++n;
    else if ((c == 0xCC || c == 0xCD) && next >= 0x80)
      ++n;  // a combining accent after its letter
    else if (c < 0x80 && (std::isalpha(c) != 0 || (digits == Digits::kKeep && std::isdigit(c) != 0)))
      text += static_cast<char>(std::tolower(c));
    else
      text += ' ';
  }
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(' '); at != std::string::npos;) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (!words.empty() && words.back() == "sous" && word.starts_with("clavi"))
      words.back() += word;
    else
      words.push_back(word);
    at = text.find_first_not_of(' ', end);
  }
  return words;
}

bool isSideWord(std::string_view word, BodySide side) {
  return std::ranges::any_of(kSides, [&](const SideWords& known) {
    return known.side == side && std::ranges::find(known.words, word) != known.words.end();
  });
}

std::optional<BodySide> sideInName(std::string_view name) {
  std::optional<BodySide> found;
  for (const auto& side : sidesOf(foldedWords(name, Digits::kKeep))) {
    if (side && found && *found != *side) return std::nullopt;
    if (side) found = side;
  }
  return found;
}

std::string nameWithoutSide(std::string_view name) {
  const std::vector<std::string> words = foldedWords(name, Digits::kKeep);
  const auto sides = sidesOf(words);
  std::string text;
  for (std::size_t n = 0; n < words.size(); ++n)
    if (!sides[n] && !hasDigit(words[n])) text += (text.empty() ? "" : " ") + words[n];
  return text;
}

}  // namespace insonate
