#include "FoldedWords.h"
#include "StructureTable.h"

#include <insonate/cases/LabelFile.h>

#include <algorithm>
#include <set>

namespace insonate {
namespace {

bool isThere(const ReadStructure& structure) {
  return structure.state == StructureState::kTaken || structure.state == StructureState::kDoubtful;
}

/// Tells whether a structure is the needed one, or may be it: "carotid artery" may be a common carotid artery, and a
/// vein without a known name may be any vein.
bool mayBe(const ReadStructure& structure, const Structure& needed) {
  if (structure.label != needed.label) return false;
  return structure.known.empty() || needed.name.ends_with(structure.known);
}

std::string pluralOf(const std::string& name) {
  return name.ends_with("y") ? name.substr(0, name.size() - 1) + "ies" : name + "s";
}

/// "right internal jugular vein", "internal jugular veins"; empty if nothing is missing.
std::string missingOf(const Structure& needed, std::span<const ReadStructure> structures) {
  bool right = false, left = false;
  for (const ReadStructure& structure : structures) {
    if (!isThere(structure) || !mayBe(structure, needed)) continue;
    const auto side = sideInName(structure.vessel.empty() ? structure.name : structure.vessel);
    right = right || side != BodySide::Left;
    left = left || side != BodySide::Right;
  }
  if (right && left) return {};
  if (right || left) return (right ? "left " : "right ") + needed.name;
  return needed.hasSides ? pluralOf(needed.name) : needed.name;
}

}  // namespace

std::vector<std::string> missingForLines(std::span<const ReadStructure> structures) {
  const StructureTable& table = structureTable();
  const auto structureNamed = [&table](const std::string& name) {
    return std::ranges::find(table.structures, name, &Structure::name);
  };
  std::set<std::string> regions;
  for (const ReadStructure& structure : structures)
    if (const auto known = structureNamed(structure.known); isThere(structure) && known != table.structures.end())
      regions.insert(known->region);
  std::vector<std::string> sentences;
  for (const LineNeed& need : table.needs) {
    if (!regions.contains(need.region)) continue;
    const Structure& needed = *structureNamed(need.structure);
    const std::string missing = missingOf(needed, structures);
    if (missing.empty()) continue;
    const bool isPlural = missing == pluralOf(needed.name);
    const std::string pronoun = isPlural ? "them" : "it";
    sentences.push_back("The " + missing + (isPlural ? " are" : " is") + " missing. " +
                        (need.task.empty()
                             ? "No task of TotalSegmentator finds " + pronoun + "; label " + pronoun + " in Prepare."
                             : "TotalSegmentator finds " + pronoun + " with the task " + need.task + "."));
  }
  return sentences;
}

}  // namespace insonate
