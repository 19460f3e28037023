#include "JsonFields.h"

#include <insonate/core/Words.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>

namespace insonate::tissuefile {
namespace {

using nlohmann::json;

std::string rangeOf(double low, double high) {
  return shown(low) + " to " + shown(high);
}

std::string rangeOf(const Limits& limits) {
  return rangeOf(limits.low, limits.high) + (limits.infinite ? ", or \"infinity\"" : "");
}

std::optional<double> numberOf(const json& value, bool infinite) {
  if (value.is_number()) return value.get<double>();
  if (infinite && value == "infinity") return std::numeric_limits<double>::infinity();
  return std::nullopt;
}

/// The range beside a value: two numbers in order, the value between them.
Result<void> checkStatedRange(const json& range, double value, bool infinite, const std::string& what) {
  const bool pair = range.is_array() && range.size() == 2;
  const auto low = pair ? numberOf(range[0], infinite) : std::nullopt;
  const auto high = pair ? numberOf(range[1], infinite) : std::nullopt;
  if (!low || !high || *low > *high) return fail(what + ": range must be [low, high], not " + shown(range) + ".");
  if (value < *low || value > *high)
    return fail(what + " is " + shown(value) + ", outside its own range " + rangeOf(*low, *high) + ".");
  return {};
}

}  // namespace

std::string shown(const json& value) {
  const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

Result<double> readNumber(const json& entry, const Limits& limits, const std::string& what) {
  const bool annotated = entry.is_object();
  if (annotated) {
    if (auto ok = checkKeys(entry, {"value", "range", "source"}, what); !ok) return tl::unexpected(ok.error());
    if (!entry.contains("value")) return fail(what + " has no \"value\".");
    if (entry.contains("source") && !entry["source"].is_string())
      return fail(what + ": source must be a text, not " + shown(entry["source"]) + ".");
  }
  const json& given = annotated ? entry["value"] : entry;
  const auto number = numberOf(given, limits.infinite);
  if (!number) return fail(what + " must be a number from " + rangeOf(limits) + ", not " + shown(given) + ".");
  const bool allowed = (*number >= limits.low && *number <= limits.high) || given.is_string();
  if (!allowed) return fail(what + " is " + shown(*number) + "; allowed is " + rangeOf(limits) + ".");
  if (annotated && entry.contains("range"))
    if (auto ok = checkStatedRange(entry["range"], *number, limits.infinite, what); !ok)
      return tl::unexpected(ok.error());
  return *number;
}

Result<void> checkKeys(const json& object, const std::vector<std::string_view>& known, const std::string& where) {
  if (!object.is_object()) return fail(where + " must be a JSON object { ... }, not " + shown(object) + ".");
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string_view near = nearestWord(key, known);
    return fail(
        where + ": unknown field '" + key +
        (near.empty() ? "'; known are " + joinedWords(known) + "." : "'; did you mean '" + std::string(near) + "'?"));
  }
  return {};
}

Result<Label> readLabel(const json& entry) {
  if (!entry.is_object()) return fail("Each of \"tissues\" must be a JSON object { ... }, not " + shown(entry) + ".");
  const auto found = entry.find("label");
  if (found == entry.end()) return fail("An entry of \"tissues\" has no \"label\".");
  if (found->is_number_integer()) {
    const auto number = found->get<std::int64_t>();
    if (number >= 0 && number < kLabelCount) return static_cast<Label>(number);
  }
  std::vector<std::string_view> names;
  for (const LabelInfo& info : labelTable()) names.push_back(info.name);
  if (!found->is_string())
    return fail("Tissue label " + shown(*found) + " is not known; use a number from 0 to " +
                std::to_string(kLabelCount - 1) + " or a name: " + joinedWords(names) + ".");
  const std::string name = found->get<std::string>();
  if (const auto label = labelFromName(name)) return *label;
  const std::string_view near = nearestWord(name, names);
  return fail("Tissue label '" + name + "' is not known; " +
              (near.empty() ? "known are " + joinedWords(names) + "." : "did you mean '" + std::string(near) + "'?"));
}

}  // namespace insonate::tissuefile
