#include "structures/FoldedWords.h"

#include <insonate/cases/VesselName.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace insonate {
namespace {

/// Words, or beginnings of words, of each meaning: English, German, French, Spanish, Latin. Written as foldedWords()
/// writes them.
using Words = std::vector<std::string_view>;

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
  const auto states = [&words](BodySide side) {
    return std::ranges::any_of(words, [side](const std::string& word) { return isSideWord(word, side); });
  };
  const bool right = states(BodySide::Right), left = states(BodySide::Left);
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
