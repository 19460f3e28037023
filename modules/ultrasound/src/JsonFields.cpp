#include "JsonFields.h"

#include <insonate/core/Words.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace insonate::fields {
namespace {

std::string typed(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string wrongType(std::string_view name, const nlohmann::json& value, std::string_view wanted,
                      const std::string& where) {
  std::string shown = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (shown.size() > 40) shown = shown.substr(0, 40) + "...";
  return where + ": " + std::string(name) + " must be " + std::string(wanted) + ", not " + shown + ".";
}

}  // namespace

Result<nlohmann::json> parseFile(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return fail(file.string() + " is a folder; a JSON file is needed.");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return fail(file.string() + " cannot be opened; check the path and the permissions.");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parseText(text, file.string());
}

Result<nlohmann::json> parseText(std::string_view text, const std::string& where) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& exception) {
    return fail(where + " is not valid JSON: " + jsonProblem(exception.what()) + ".");
  }
}

Result<void> checkKeys(const nlohmann::json& object, const std::vector<std::string_view>& known,
                       const std::string& where) {
  if (!object.is_object()) return fail(where + ": a JSON object { ... } is needed.");
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string_view near = nearestWord(key, known);
    return fail(where + ": unknown field '" + key + "'" +
                (near.empty() ? "; known are " + joinedWords(known) : "; did you mean '" + std::string(near) + "'?") +
                (near.empty() ? "." : ""));
  }
  return {};
}

Result<double> readNumber(const nlohmann::json& value, std::string_view name, const std::string& where) {
  if (!value.is_number()) return fail(wrongType(name, value, "a number", where));
  return value.get<double>();
}

Result<int> readInteger(const nlohmann::json& value, std::string_view name, const std::string& where) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(std::abs(number) <= 1e9) || number != std::floor(number))
    return fail(wrongType(name, value, "a whole number", where));
  return static_cast<int>(number);
}

Result<bool> readSwitch(const nlohmann::json& value, std::string_view name, const std::string& where) {
  if (!value.is_boolean()) return fail(wrongType(name, value, "true or false", where));
  return value.get<bool>();
}

Result<int> readChoice(const nlohmann::json& value, const std::vector<std::string_view>& choices, std::string_view name,
                       const std::string& where) {
  const auto found =
      value.is_string() ? std::find(choices.begin(), choices.end(), value.get<std::string>()) : choices.end();
  if (found == choices.end()) return fail(wrongType(name, value, "one of " + joinedWords(choices), where));
  return static_cast<int>(found - choices.begin());
}

Result<void> checkRange(double value, double low, double high, std::string_view name, const std::string& where) {
  if (value >= low && value <= high) return {};
  return fail(where + ": " + std::string(name) + " is " + typed(value) + "; allowed is " + typed(low) + " to " +
              typed(high) + ".");
}

}  // namespace insonate::fields
