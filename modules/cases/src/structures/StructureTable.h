#pragma once

#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate {

/// A structure in the files of other programs.
struct Structure {
  std::string name;              ///< e.g. "internal jugular vein"
  std::optional<Label> label{};  ///< no value: no label has its tissue, and an import leaves it out
  bool hasSides = false;         ///< true for a vessel that the body has on both sides
  bool isGroup = false;          ///< true for several vessels of one name, which are no named vessel of a case
  bool isMidline = false;        ///< true if the structure lies in the middle of the body
  std::string region{};          ///< "neck", "chest" or "groin" if the structure shows that the CT contains the region
};

/// A structure that a central line in a region needs.
struct LineNeed {
  std::string region, structure;
  std::string task;  ///< task of TotalSegmentator that finds the structure; empty if no task does
};

/// The table resources/maps/structures.json.
struct StructureTable {
  std::vector<Structure> structures;
  std::map<std::string, std::size_t, std::less<>> byName, byCode;
  std::vector<std::pair<std::string, Label>> words;  ///< parts of names; the first match determines the label
  std::map<Label, int> priority;                     ///< where structures overlap, the highest one wins
  std::vector<LineNeed> needs;
};

/// Parses a table. Fails with a sentence that states the entry and its error.
Result<StructureTable> readStructureTable(std::string_view text);

/// Returns the built-in table.
const StructureTable& structureTable();

/// Returns the structure with this name, in any order of the words and with or without the side; null if the name is
/// unknown. Vessels are also recognized by their names in five languages.
const Structure* structureOfName(std::string_view name);

/// Returns the structure with this SNOMED CT code; null if the code is unknown.
const Structure* structureOfCode(std::string_view code);

/// Returns the label that a part of the name determines, e.g. "artery".
std::optional<Label> labelOfWords(std::string_view name);

}  // namespace insonate
