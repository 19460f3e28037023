#pragma once

#include "JsonFields.h"

#include <insonate/core/Preset.h>
#include <insonate/core/Words.h>

#include <bitset>
#include <filesystem>
#include <fstream>
#include <iterator>

/// A table of properties by label, as a preset or a file: what resources/tissues and resources/mechanics share.
namespace insonate::tissuefile {

/// Properties that distinguish one kind of table. `Table` has a name and `tissues` by label.
template <class Table>
struct TableForm {
  using Tissue = typename decltype(Table::tissues)::value_type;

  std::string noun;             ///< "tissue": a tissue preset, a tissue file
  std::vector<Preset> presets;  ///< the default first

  /// Fills `tissue` from an entry of "tissues". With `complete`, every number has to be there; without, the missing
  /// ones stay as they are.
  Result<void> (*readTissue)(const nlohmann::json& entry, bool complete, const std::string& where, Tissue& tissue);

  std::vector<std::string_view> names() const {
    std::vector<std::string_view> all;
    for (const Preset& preset : presets) all.push_back(preset.name);
    return all;
  }
  const Preset* named(std::string_view name) const {
    for (const Preset& preset : presets)
      if (preset.name == name) return &preset;
    return nullptr;
  }
  std::string unknown(std::string_view name) const {
    const std::string_view near = nearestWord(name, names());
    std::string sentence = "'" + std::string(name) + "' is not a " + noun + " preset (" + joinedWords(names()) + ")";
    return near.empty() ? sentence + "." : sentence.append("; did you mean '").append(near).append("'?");
  }
};

/// "name", "description" and "sources" are for readers; they only have to be text.
Result<void> checkRemarks(const nlohmann::json& file);

/// Parses JSON; fails with the place of the error.
Result<nlohmann::json> parsedJson(std::string_view text);

template <class Table>
Result<Table> parseTable(std::string_view text, const TableForm<Table>& form);

template <class Table>
Result<Table> baseOf(const nlohmann::json& file, const TableForm<Table>& form) {
  if (!file.contains("base")) return Table{};
  if (!file["base"].is_string())
    return fail("\"base\" must be the name of a preset: " + joinedWords(form.names()) + ".");
  const std::string name = file["base"].get<std::string>();
  const Preset* preset = form.named(name);
  if (!preset) return fail("The base " + form.unknown(name));
  return parseTable(preset->text, form);
}

template <class Table>
Result<Table> readTable(const nlohmann::json& file, const TableForm<Table>& form) {
  const auto keys =
      checkKeys(file, {"name", "description", "base", "sources", "tissues"}, "The " + form.noun + " file");
  if (!keys) return tl::unexpected(keys.error());
  if (auto ok = checkRemarks(file); !ok) return tl::unexpected(ok.error());
  auto table = baseOf(file, form);
  if (!table) return table;
  table->name = file.value("name", "");
  const bool complete = !file.contains("base");
  const nlohmann::json tissues = file.value("tissues", nlohmann::json::array());
  if (!tissues.is_array()) return fail("\"tissues\" must be a list [ ... ].");
  std::bitset<kLabelCount> seen;
  for (const nlohmann::json& entry : tissues) {
    const auto label = readLabel(entry);
    if (!label) return tl::unexpected(label.error());
    const std::string where = "tissue '" + std::string(labelTable()[*label].name) + "'";
    if (seen[*label]) return fail(where + " is listed twice; keep one entry.");
    seen.set(*label);
    if (auto ok = form.readTissue(entry, complete, where, table->tissues[*label]); !ok)
      return tl::unexpected(ok.error());
  }
  for (int label = 0; complete && label < kLabelCount; ++label)
    if (!seen[label])
      return fail("tissue '" + std::string(labelTable()[label].name) +
                  "' is missing; list it, or name a preset as \"base\": " + joinedWords(form.names()) + ".");
  return table;
}

template <class Table>
Result<Table> parseTable(std::string_view text, const TableForm<Table>& form) {
  const auto file = parsedJson(text);
  if (!file) return tl::unexpected(file.error());
  return readTable(*file, form);
}

template <class Table>
Result<Table> loadTable(std::string_view nameOrPath, const TableForm<Table>& form) {
  if (const Preset* preset = form.named(nameOrPath)) return parseTable(preset->text, form);
  const std::filesystem::path path(nameOrPath);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return fail("No such " + form.noun + " file: " + form.unknown(nameOrPath));
  if (!std::filesystem::is_regular_file(path, error)) return fail(path.string() + " is not a " + form.noun + " file.");
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return fail(path.string() + " cannot be read; check its permissions.");
  auto table = parseTable(text, form);
  if (!table) return fail(path.string() + ": " + table.error().message);
  if (table->name.empty()) table->name = path.stem().string();
  return table;
}

/// A file that parseTable() reads, complete. `written` is the entry of one tissue but for its label.
template <class Table>
std::string tableText(const Table& table, nlohmann::json (*written)(const typename TableForm<Table>::Tissue&)) {
  nlohmann::json tissues = nlohmann::json::array();
  for (int label = 0; label < kLabelCount; ++label) {
    nlohmann::json entry = written(table.tissues[label]);
    entry["label"] = labelTable()[label].name;
    tissues.push_back(std::move(entry));
  }
  const nlohmann::json file{{"name", table.name}, {"tissues", std::move(tissues)}};
  return file.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace insonate::tissuefile
