#include "LabelNames.h"

#include "../structures/StructureTable.h"

#include <insonate/cases/VesselName.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace insonate {

std::optional<Label> labelFromSnomed(std::string_view code) {
  if (code.empty()) return std::nullopt;
  for (const LabelInfo& info : labelTable())
    if (info.snomedCode == code) return info.label;
  const Structure* structure = structureOfCode(code);
  return structure ? structure->label : std::nullopt;
}

std::optional<Label> labelFromAnyName(std::string_view name) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (const auto exact = labelFromName(lower)) return exact;
  if (const Structure* structure = structureOfName(name)) return structure->label;
  const auto matching = labelOfWords(name);
  const bool isBesideVessels = matching == kLymphNode || matching == kNerve;
  // "A. vertebralis" is no vertebra.
  if (const VesselName vessel = parsedVesselName(name); vessel.vessel && vessel.label && !isBesideVessels)
    return vessel.label;
  return matching;
}

std::string knownStructure(std::string_view name, std::string_view code) {
  const Structure* byName = structureOfName(name);
  const Structure* byCode = structureOfCode(code);
  if (byName && byCode && byName->label != byCode->label) return byCode->name;
  return byName ? byName->name : byCode ? byCode->name : std::string();
}

bool isTaken(const ReadStructure& structure, const StructureChoices& choices, bool otherwise) {
  const auto isNamed = [&] {
    return choices.only.contains(structure.key()) || choices.only.contains(std::to_string(structure.number));
  };
  if (!choices.only.empty()) return isNamed();
  const auto chosen = choices.taken.find(structure.key());
  return chosen == choices.taken.end() ? otherwise : chosen->second;
}

bool isLeftOut(std::string_view name) {
  const Structure* structure = structureOfName(name);
  return structure && !structure->label;
}

}  // namespace insonate
