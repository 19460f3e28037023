#include <insonate/tissue/OwnLabels.h>

#include <cstddef>
#include <utility>

namespace insonate {
namespace {

constexpr std::size_t kMaxBytes = 64;  // limit of a long string in DICOM (PS3.5 6.2: LO)

/// Number of bytes of the UTF-8 character that begins here; 0 if there is none (RFC 3629).
std::size_t characterAt(std::string_view text) {
  const auto byte = [&](std::size_t n) { return n < text.size() ? static_cast<unsigned char>(text[n]) : 0U; };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
  unsigned code = length < 2 ? first : first & (0xffU >> (length + 1));
  for (std::size_t n = 1; n < length; ++n) {
    if (byte(n) >> 6 != 2) return 0;
    code = code << 6 | (byte(n) & 0x3fU);
  }
  constexpr unsigned kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < kLeast[length] || code > 0x10ffff || surrogate ? 0 : length;
}

/// C0 and C1 controls, and line and paragraph separators.
bool breaksTheLine(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first < 0x20 || first == 0x7f;
  if (character.size() == 2) return first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
  return character == "\u2028" || character == "\u2029";
}

}  // namespace

std::string tidyLabelName(std::string_view name) {
  std::string tidy;
  bool space = false;
  while (!name.empty()) {
    const std::size_t length = characterAt(name);
    std::string_view character = length > 0 ? name.substr(0, length) : "?";
    name.remove_prefix(length > 0 ? length : 1);
    if (character == " " || breaksTheLine(character)) {
      space = !tidy.empty();
      continue;
    }
    if (character == "\"") character = "'";
    if (character == "\\") character = "/";
    if (tidy.size() + space + character.size() > kMaxBytes) break;
    if (std::exchange(space, false)) tidy += ' ';
    tidy += character;
  }
  return tidy;
}

std::string labelName(const OwnLabels& own, std::uint8_t label) {
  const auto found = own.find(label);
  return found != own.end() && !found->second.name.empty() ? found->second.name : labelName(label);
}

std::uint8_t tissueOf(const OwnLabels& own, std::uint8_t label) {
  const auto found = own.find(label);
  return found != own.end() ? std::uint8_t{found->second.tissue} : label;
}

}  // namespace insonate
