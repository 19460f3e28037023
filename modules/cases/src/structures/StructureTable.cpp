#include "StructureTable.h"

#include "FoldedWords.h"

#include <insonate/cases/VesselName.h>
#include <insonate/core/JsonEntry.h>
#include <insonate/embedded/maps.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace insonate {
namespace {

using nlohmann::json;

Label labelIn(JsonEntry& entry) {
  const std::string name = entry.text("label");
  const auto label = labelFromName(name);
  if (!label) entry.setError("has the unknown label '" + name + "'");
  return label.value_or(kSoftTissue);
}

void addKey(const std::string& key, std::size_t structure, std::map<std::string, std::size_t, std::less<>>& keys,
            JsonEntry& entry) {
  if (!keys.emplace(key, structure).second) entry.setError("has the name or code '" + key + "' of another structure");
}

void addStructure(const json& object, const std::string& where, std::string& error, StructureTable& table) {
  JsonEntry entry(object, where, {"name", "label", "sides", "group", "midline", "region", "codes", "names"}, error);
  Structure structure{entry.text("name")};
  if (entry.has("label")) structure.label = labelIn(entry);
  structure.hasSides = entry.flag("sides");
  structure.isGroup = entry.flag("group");
  structure.isMidline = entry.flag("midline");
  structure.region = entry.text("region", false);
  const std::size_t at = table.structures.size();
  addKey(nameWithoutSide(structure.name), at, table.byName, entry);
  if (entry.has("names"))
    for (const std::string& name : entry.texts("names"))
      if (nameWithoutSide(name) != nameWithoutSide(structure.name))
        addKey(nameWithoutSide(name), at, table.byName, entry);
  if (entry.has("codes"))
    for (const std::string& code : entry.texts("codes")) addKey(code, at, table.byCode, entry);
  table.structures.push_back(std::move(structure));
}

void readPriority(JsonEntry& file, StructureTable& table) {
  for (const std::string& name : file.texts("priority")) {
    const auto label = labelFromName(name);
    if (!label) return file.setError("has the unknown label '" + name + "' in \"priority\"");
    table.priority.emplace(*label, static_cast<int>(table.priority.size()) + 1);
  }
}

/// "A. profunda femoris" is in the family of the femoral artery, but it is a branch.
bool namesBranch(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 6> kBranches{"profund",  "deep",       "tief",
                                                      "superfic", "circumflex", "zirkumflex"};
  return std::ranges::any_of(words, [&](const std::string& word) {
    return std::ranges::any_of(kBranches, [&](std::string_view branch) { return word.starts_with(branch); });
  });
}

const Structure* structureOfVessel(std::string_view name) {
  const VesselName parsed = parsedVesselName(name);
  const auto beside = labelOfWords(name);
  if (!parsed.vessel || !parsed.label || beside == kLymphNode || beside == kNerve || namesBranch(foldedWords(name)))
    return nullptr;
  const auto& all = structureTable().structures;
  const auto found = std::ranges::find_if(all, [&](const Structure& one) {
    return one.label == parsed.label && parsedVesselName(one.name).vessel == parsed.vessel;
  });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

Result<StructureTable> readStructureTable(std::string_view text) {
  const auto content = parsedJson(text, "The table of structures");
  if (!content) return tl::unexpected(content.error());
  StructureTable table;
  std::string error;
  JsonEntry file(*content, "The table of structures",
                 {"description", "source", "structures", "words", "priority", "lines"}, error);
  file.forEach("structures", "structure", [&table](const json& object, const std::string& where, std::string& failed) {
    addStructure(object, where, failed, table);
  });
  file.forEach("words", "word", [&table](const json& object, const std::string& where, std::string& failed) {
    JsonEntry entry(object, where, {"word", "label"}, failed);
    table.words.emplace_back(entry.text("word"), labelIn(entry));
  });
  readPriority(file, table);
  file.forEach("lines", "line", [&table](const json& object, const std::string& where, std::string& failed) {
    JsonEntry entry(object, where, {"region", "structure", "task"}, failed);
    table.needs.push_back({entry.text("region"), entry.text("structure"), entry.text("task", false)});
    if (std::ranges::find(table.structures, table.needs.back().structure, &Structure::name) == table.structures.end())
      entry.setError("needs a structure that is not in the table");
  });
  if (!error.empty()) return fail(error);
  return table;
}

const StructureTable& structureTable() {
  static const StructureTable table = [] {
    auto read = readStructureTable(embedded::maps::files().front().text);
    if (!read) throw std::logic_error(read.error().message);  // a test reads the built-in table
    return std::move(*read);
  }();
  return table;
}

const Structure* structureOfName(std::string_view name) {
  const StructureTable& table = structureTable();
  if (const auto found = table.byName.find(nameWithoutSide(name)); found != table.byName.end())
    return &table.structures[found->second];
  return structureOfVessel(name);
}

const Structure* structureOfCode(std::string_view code) {
  const StructureTable& table = structureTable();
  const auto found = table.byCode.find(code);
  return found == table.byCode.end() ? nullptr : &table.structures[found->second];
}

std::optional<Label> labelOfWords(std::string_view name) {
  std::string text;
  for (const std::string& word : foldedWords(name)) text += " " + word;
  for (const auto& [word, label] : structureTable().words)
    if (text.find(word) != std::string::npos) return label;
  return std::nullopt;
}

}  // namespace insonate
