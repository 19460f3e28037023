#include "TableFile.h"

namespace insonate::tissuefile {

using nlohmann::json;

Result<void> checkRemarks(const json& file) {
  for (const char* key : {"name", "description"})
    if (file.contains(key) && !file[key].is_string()) return fail(std::string("\"") + key + "\" must be a text.");
  if (!file.contains("sources")) return {};
  if (!file["sources"].is_object()) return fail("\"sources\" must be an object of short names and citations.");
  for (const auto& [key, citation] : file["sources"].items())
    if (!citation.is_string()) return fail("The citation of source '" + key + "' must be a text.");
  return {};
}

Result<json> parsedJson(std::string_view text) {
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    return fail("This is not valid JSON: " + jsonProblem(error.what()) + ".");
  }
}

}  // namespace insonate::tissuefile
