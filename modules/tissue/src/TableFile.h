#pragma once

#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/core/Words.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <bitset>
#include <filesystem>

/// Reading and writing of tables of properties by label, shared by all kinds of tissue tables, as presets or files.
namespace insonate::tissuefile {

/// Description of one kind of tissue table (acoustic, mechanical or needle) for the functions that read and write all
/// kinds. `Table` has a `name`, and `tissues` by label.
template <class Table>
struct TableForm {
  using Tissue = typename decltype(Table::tissues)::value_type;

  std::string noun;             ///< word for the kind of table in sentences, e.g. "tissue" in "a tissue table"
  std::vector<Preset> presets;  ///< compiled-in tables, the default first

  /// Fills `tissue` from an entry of "tissues". With `complete`, a missing number is an error; without it, a missing
  /// number leaves the member of `tissue` unchanged.
  void (*readTissue)(const nlohmann::json& entry, bool complete, const std::string& where, std::string& error,
                     Tissue& tissue);
};

/// Checks that "description" and "sources", which only people read, are text.
void checkRemarks(JsonEntry& file);

/// Reads the entry's "label": a name or number of insonate/tissue/Labels.h.
Label readLabel(const nlohmann::json& object, const std::string& where, std::string& error);

template <class Table>
Result<Table> parseTable(std::string_view text, const TableForm<Table>& form);

template <class Table>
Table readTable(const nlohmann::json& object, const TableForm<Table>& form, std::string& error) {
  JsonEntry file(object, "The " + form.noun + " file", {"name", "description", "base", "sources", "tissues"}, error);
  checkRemarks(file);
  std::vector<std::string_view> presets;
  for (const Preset& preset : form.presets) presets.push_back(preset.name);
  const bool complete = !file.has("base");
  Table table;
  if (!complete) table = parseTable(form.presets[file.word("base", presets)].text, form).value();
  table.name = file.has("name") && file.value("name") != "" ? file.text("name") : "";
  std::bitset<kLabelCount> seen;
  file.list("tissues", "tissue", [&](const nlohmann::json& entry, const std::string& where, std::string& wrong) {
    const Label label = readLabel(entry, where, wrong);
    const std::string tissue = "tissue '" + std::string(labelTable()[label].name) + "'";
    form.readTissue(entry, complete, tissue, wrong, table.tissues[label]);
    if (wrong.empty() && seen[label]) wrong = tissue + " is listed twice; keep one entry.";
    seen.set(label);
    return label;
  });
  for (int label = 0; complete && label < kLabelCount; ++label)
    if (!seen[label])
      file.setError("has no tissue '" + std::string(labelTable()[label].name) +
                    "'; list it, or name a preset as 'base': " + joinedWords(presets) + ".");
  return table;
}

template <class Table>
Result<Table> parseTable(std::string_view text, const TableForm<Table>& form) {
  const auto file = parsedJson(text, "The " + form.noun + " file");
  if (!file) return tl::unexpected(file.error());
  std::string error;
  Table table = readTable(*file, form, error);
  if (!error.empty()) return fail(std::move(error));
  return table;
}

template <class Table>
Result<Table> loadTable(std::string_view nameOrPath, const TableForm<Table>& form) {
  auto table = presetOrFile("a " + form.noun + " table", nameOrPath, form.presets,
                            [&](std::string_view text) { return parseTable(text, form); });
  if (table && table->name.empty()) table->name = std::filesystem::path(nameOrPath).stem().string();
  return table;
}

/// Writes a complete file for parseTable(). `written` makes the JSON entry of one tissue, without the label.
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
