#include "TissueFields.h"

#include <insonate/core/Words.h>
#include <insonate/embedded/tissues.h>
#include <insonate/tissue/AcousticTable.h>

#include <bitset>
#include <fstream>
#include <iterator>

namespace insonate {
namespace {

using nlohmann::json;

std::vector<std::string_view> presets() {
  std::vector<std::string_view> names;
  for (const auto& file : embedded::tissues::files()) names.push_back(file.name);
  return names;
}

const embedded::tissues::File* presetNamed(std::string_view name) {
  for (const auto& file : embedded::tissues::files())
    if (file.name == name) return &file;
  return nullptr;
}

std::string unknownPreset(std::string_view name) {
  const std::string_view near = nearestWord(name, presets());
  std::string sentence = std::string("'").append(name) + "' is not a tissue preset (" + joinedWords(presets()) + ")";
  return near.empty() ? sentence + "." : sentence.append("; did you mean '").append(near).append("'?");
}

Result<AcousticTable> baseOf(const json& file) {
  if (!file.contains("base")) return AcousticTable{};
  if (!file["base"].is_string()) return fail("\"base\" must be the name of a preset: " + joinedWords(presets()) + ".");
  const std::string name = file["base"].get<std::string>();
  const auto* preset = presetNamed(name);
  if (!preset) return fail("The base " + unknownPreset(name));
  return parseAcousticTable(preset->text);
}

/// "name", "description" and "sources" are for readers; they only have to be text.
Result<void> checkRemarks(const json& file) {
  for (const char* key : {"name", "description"})
    if (file.contains(key) && !file[key].is_string()) return fail(std::string("\"") + key + "\" must be a text.");
  if (!file.contains("sources")) return {};
  if (!file["sources"].is_object()) return fail("\"sources\" must be an object of short names and citations.");
  for (const auto& [key, citation] : file["sources"].items())
    if (!citation.is_string()) return fail("The citation of source '" + key + "' must be a text.");
  return {};
}

Result<AcousticTable> readTable(const json& file) {
  if (auto ok = tissuefile::checkKeys(file, {"name", "description", "base", "sources", "tissues"}, "The tissue file");
      !ok)
    return tl::unexpected(ok.error());
  if (auto ok = checkRemarks(file); !ok) return tl::unexpected(ok.error());
  auto table = baseOf(file);
  if (!table) return table;
  table->name = file.value("name", "");
  const bool complete = !file.contains("base");
  const json tissues = file.value("tissues", json::array());
  if (!tissues.is_array()) return fail("\"tissues\" must be a list [ ... ].");
  std::bitset<kLabelCount> seen;
  for (const json& entry : tissues) {
    const auto label = tissuefile::readLabel(entry);
    if (!label) return tl::unexpected(label.error());
    const std::string where = "tissue '" + std::string(labelTable()[*label].name) + "'";
    if (seen[*label]) return fail(where + " is listed twice; keep one entry.");
    seen.set(*label);
    if (auto ok = tissuefile::readTissue(entry, complete, where, table->tissues[*label]); !ok)
      return tl::unexpected(ok.error());
  }
  for (int label = 0; complete && label < kLabelCount; ++label)
    if (!seen[label])
      return fail("tissue '" + std::string(labelTable()[label].name) +
                  "' is missing; list it, or name a preset as \"base\": " + joinedWords(presets()) + ".");
  return table;
}

}  // namespace

std::vector<std::string> acousticPresetNames() {
  const auto names = presets();
  return {names.begin(), names.end()};
}

Result<AcousticTable> parseAcousticTable(std::string_view text) {
  json file;
  try {
    file = json::parse(text);
  } catch (const json::exception& error) {
    return fail("This is not valid JSON: " + jsonTrouble(error.what()) + ".");
  }
  return readTable(file);
}

Result<AcousticTable> loadAcousticTable(std::string_view nameOrPath) {
  if (const auto* preset = presetNamed(nameOrPath)) return parseAcousticTable(preset->text);
  const std::filesystem::path path(nameOrPath);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return fail("No such tissue file: " + unknownPreset(nameOrPath));
  if (!std::filesystem::is_regular_file(path, error)) return fail(path.string() + " is not a tissue file.");
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return fail(path.string() + " cannot be read; check its permissions.");
  auto table = parseAcousticTable(text);
  if (!table) return fail(path.string() + ": " + table.error().message);
  if (table->name.empty()) table->name = path.stem().string();
  return table;
}

}  // namespace insonate
