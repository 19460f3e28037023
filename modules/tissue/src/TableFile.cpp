#include "TableFile.h"

namespace insonate::tissuefile {

using nlohmann::json;

void checkRemarks(JsonEntry& file) {
  file.text("description", false);
  if (!file.has("sources")) return;
  const json& sources = file.value("sources");
  if (!sources.is_object()) return file.setError("needs an object of short names and citations as 'sources'.");
  for (const auto& [key, citation] : sources.items())
    if (!citation.is_string()) file.setError("needs a text as the citation of the source '" + key + "'.");
}

Label readLabel(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, jsonKeys(object), error);
  if (object.is_object() && object.contains("label") && object["label"].is_number())
    return static_cast<Label>(entry.integer("label", 0, kLabelCount - 1));
  std::vector<std::string_view> names;
  for (const LabelInfo& info : labelTable()) names.push_back(info.name);
  return static_cast<Label>(entry.word("label", names));
}

}  // namespace insonate::tissuefile
