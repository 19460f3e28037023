#include <insonate/cases/VesselName.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace insonate {
namespace {

/// Words, or beginnings of words, of each meaning: English, German, French, Spanish, Latin. Written as foldedWords()
/// writes them.
using Words = std::vector<std::string_view>;

struct SideWords {
  BodySide side;
  Words words;  ///< whole words
};

const std::array<SideWords, 2> kSides{
    {{BodySide::Right,
      {"right", "rt", "rechts", "rechte", "rechter", "rechtes", "rechten", "re", "droit", "droite", "derecha",
       "derecho", "dcha", "dcho", "dexter", "dextra", "dextrum", "dextrae"}},
     {BodySide::Left,
      {"left", "lt", "links", "linke", "linker", "linkes", "linken", "li", "gauche", "izquierda", "izquierdo", "izda",
       "izdo", "sinister", "sinistra", "sinistrum", "sinistrae"}}}};

struct LabelWords {
  Label label;
  Words whole, beginnings;
};

const std::array<LabelWords, 2> kLabels{
    {{kVein,
      {"v", "vein", "veins", "vena", "venae", "venas", "vene", "venen", "veine", "veines"},
      {"jugular", "yugular"}},
     {kArtery,
      {"a", "artery", "arteries", "arteria", "arteriae", "arterias", "arterie", "arterien", "artere", "arteres"},
      {"carotid", "karotid", "carotis", "karotis"}}}};

/// Family of a vessel, and the beginnings of words that name it. German writes compounds: "Jugularvene".
struct FamilyWords {
  KnownVessel family;
  Words beginnings;
};

const std::array<FamilyWords, 12> kFamilies{
    {{KnownVessel::Jugular, {"jugular", "jugulaire", "yugular", "drosselvene", "ijv", "vji"}},
     {KnownVessel::Carotid, {"carotid", "karotid", "carotis", "karotis", "halsschlagader", "cca"}},
     {KnownVessel::Subclavian, {"subclavi", "subklavi", "sousclavi", "schlusselbein", "unterschlusselbein"}},
     {KnownVessel::Axillary, {"axill", "axilar", "achsel"}},
     {KnownVessel::Brachiocephalic,
      {"brachiocephal", "brachiozephal", "braquiocefal", "innominat", "innominad", "anonyma"}},
     {KnownVessel::Vertebral, {"vertebral", "wirbel"}},
     {KnownVessel::Iliac, {"iliac", "iliaq", "iliak", "beckenarter", "beckenven"}},
     {KnownVessel::Femoral, {"femoral", "femoris", "oberschenkelven", "oberschenkelarter", "cfv", "cfa"}},
     {KnownVessel::Saphenous, {"saphen", "safen", "rosenven"}},
     {KnownVessel::Brachial, {"brachial", "braquial", "oberarmven", "oberarmarter"}},
     {KnownVessel::Basilic, {"basilic", "basilik"}},
     {KnownVessel::Cephalic, {"cephalic", "cephaliq", "cefalic", "kephalik", "zephalic"}}}};

const Words kInternal{"intern", "inner", "ijv", "vji"}, kExternal{"extern", "ausser", "aeusser"},
    kAnterior{"anterior", "vorder"}, kCommon{"common", "commun", "comun", "gemeinsam", "primitiv", "cca"};

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

/// Words in lower case without accents; "sous-clavière" becomes one word.
std::vector<std::string> foldedWords(std::string_view name) {
  std::string text;
  for (std::size_t n = 0; n < name.size(); ++n) {
    const auto c = static_cast<unsigned char>(name[n]);
    const auto next = n + 1 < name.size() ? static_cast<unsigned char>(name[n + 1]) : 0;
    if (c == 0xC3 && next >= 0x80)
      text += baseLetter(static_cast<unsigned char>(next)), ++n;
    else if ((c == 0xCC || c == 0xCD) && next >= 0x80)
      ++n;  // a combining accent after its letter
    else if (std::isalpha(c) != 0 && c < 0x80)
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

bool hasWhole(const std::vector<std::string>& words, const Words& known) {
  return std::ranges::any_of(words,
                             [&](const std::string& word) { return std::ranges::find(known, word) != known.end(); });
}

bool hasBeginning(const std::vector<std::string>& words, const Words& known) {
  return std::ranges::any_of(words, [&](const std::string& word) {
    return std::ranges::any_of(known, [&](std::string_view beginning) { return word.starts_with(beginning); });
  });
}

KnownVessel memberOf(KnownVessel family, const std::vector<std::string>& words) {
  const bool internal = hasBeginning(words, kInternal), external = hasBeginning(words, kExternal);
  if (family == KnownVessel::Jugular && !(internal && external)) {
    if (internal) return KnownVessel::InternalJugular;
    if (external) return KnownVessel::ExternalJugular;
    if (hasBeginning(words, kAnterior)) return KnownVessel::AnteriorJugular;
  }
  if (family == KnownVessel::Carotid && !(internal && external)) {
    if (internal) return KnownVessel::InternalCarotid;
    if (external) return KnownVessel::ExternalCarotid;
    if (hasBeginning(words, kCommon)) return KnownVessel::CommonCarotid;
  }
  return family;
}

}  // namespace

VesselName parsedVesselName(std::string_view name) {
  const std::vector<std::string> words = foldedWords(name);
  VesselName parsed;
  for (const FamilyWords& known : kFamilies)
    if (hasBeginning(words, known.beginnings)) {
      parsed.vessel = memberOf(known.family, words);
      break;
    }
  const bool right = hasWhole(words, kSides[0].words), left = hasWhole(words, kSides[1].words);
  if (right != left) parsed.side = right ? BodySide::Right : BodySide::Left;
  for (const LabelWords& known : kLabels)
    if (!parsed.label && (hasWhole(words, known.whole) || hasBeginning(words, known.beginnings)))
      parsed.label = known.label;
  return parsed;
}

bool namesVessel(std::string_view name, std::string_view vessel) {
  if (name.find(vessel) != std::string_view::npos) return true;
  const VesselName a = parsedVesselName(name), b = parsedVesselName(vessel);
  const bool sides = !a.side || !b.side || a.side == b.side, labels = !a.label || !b.label || a.label == b.label;
  return a.vessel && a.vessel == b.vessel && sides && labels;
}

}  // namespace insonate
