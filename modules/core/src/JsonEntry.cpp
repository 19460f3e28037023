#include <insonate/core/JsonEntry.h>
#include <insonate/core/Words.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

namespace insonate {
namespace {

using nlohmann::json;

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string shown(const json& value) {
  constexpr std::size_t kMost = 40;
  if (value.is_structured() && !value.empty()) return value.is_array() ? "[ ... ]" : "{ ... }";
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return shown(value.get<double>());
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

std::string shownRange(double low, double high, bool allowInfinity = false) {
  return shown(low) + " to " + shown(high) + (allowInfinity ? ", or \"infinity\"," : "");
}

std::optional<double> numberIn(const json& value, bool allowInfinity) {
  if (allowInfinity && value == "infinity") return std::numeric_limits<double>::infinity();
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::string didYouMean(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view near = nearestWord(word, known);
  return near.empty() ? "; it is one of " + joinedWords(known) + "." : "; did you mean '" + std::string(near) + "'?";
}

}  // namespace

Result<json> parsedJson(std::string_view text, const std::string& what) {
  try {
    return json::parse(text);
  } catch (const json::exception& e) {
    return fail(what + " is not valid JSON: " + readableJsonError(e.what()) + ".");
  }
}

std::vector<std::string_view> jsonKeys(const json& object) {
  std::vector<std::string_view> keys;
  if (object.is_object())
    for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

JsonEntry::JsonEntry(const json& object, std::string where, const std::vector<std::string_view>& known,
                     std::string& error)
    : object_(object), where_(std::move(where)), error_(error) {
  if (!object.is_object()) {
    setError("must be an object { ... }, not " + shown(object) + ".");
    return;
  }
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(known, key) == known.end()) setError("has an unknown '" + key + "'" + didYouMean(key, known));
}

void JsonEntry::setError(const std::string& sentence) {
  if (error_.empty()) error_ = where_ + " " + sentence;
}

const json* JsonEntry::find(std::string_view key, bool needed) {
  if (!error_.empty()) return nullptr;
  const auto found = object_.find(key);
  if (found != object_.end()) return &*found;
  if (needed) setError("has no '" + std::string(key) + "'.");
  return nullptr;
}

std::string JsonEntry::text(std::string_view key, bool needed) {
  const json* value = find(key, needed);
  if (!value) return {};
  std::string text = value->is_string() ? value->get<std::string>() : std::string();
  const bool hasZeroByte = text.find('\0') != std::string::npos;
  if (!hasZeroByte && (!text.empty() || (!needed && value->is_string()))) return text;
  if (hasZeroByte)
    setError("holds a zero byte (\\u0000) in its '" + std::string(key) + "'; remove it.");
  else
    setError("needs a text as '" + std::string(key) + "', not " + shown(*value) + ".");
  return {};
}

std::optional<double> JsonEntry::boundedNumber(std::string_view key, double low, double high, bool allowInfinity) {
  const json* value = find(key, false);
  if (!value) return std::nullopt;
  const auto number = numberIn(*value, allowInfinity);
  if (number && (value->is_string() || (*number >= low && *number <= high))) return number;
  setError("needs a number from " + shownRange(low, high, allowInfinity) + " as '" + std::string(key) + "', not " +
           shown(*value) + ".");
  return std::nullopt;
}

std::optional<double> JsonEntry::optionalNumber(std::string_view key, double low, double high) {
  return boundedNumber(key, low, high, false);
}

std::optional<double> JsonEntry::optionalNumberWithSource(std::string_view key, double low, double high,
                                                          bool allowInfinity) {
  const json* given = find(key, false);
  if (!given || !given->is_object()) return boundedNumber(key, low, high, allowInfinity);
  JsonEntry sourced(*given, where_ + ", " + std::string(key) + ",", {"value", "range", "source"}, error_);
  sourced.text("source", false);
  if (!sourced.find("value", true)) return std::nullopt;
  const auto value = sourced.boundedNumber("value", low, high, allowInfinity);
  if (value) sourced.checkStatedRange(*value);
  return value;
}

/// A "range" beside a value tells how well the value is known.
void JsonEntry::checkStatedRange(double value) {
  const json* range = find("range", false);
  if (!range) return;
  const bool isPair = range->is_array() && range->size() == 2;
  const auto low = isPair ? numberIn((*range)[0], true) : std::nullopt;
  const auto high = isPair ? numberIn((*range)[1], true) : std::nullopt;
  if (!low || !high || *low > *high)
    setError("needs [low, high] as 'range', not " + shown(*range) + ".");
  else if (value < *low || value > *high)
    setError("has the value " + shown(value) + ", outside its own range " + shownRange(*low, *high) + ".");
}

std::vector<double> JsonEntry::numbers(std::string_view key, std::size_t count, double low, double high,
                                       std::string_view order) {
  std::vector<double> all(count);
  const json* list = find(key, true);
  if (list && (!list->is_array() || list->size() != count))
    setError("needs a list of " + std::to_string(count) + " numbers" + (order.empty() ? "" : ", ") +
             std::string(order) + (order.empty() ? "" : ",") + " as '" + std::string(key) + "', not " + shown(*list) +
             ".");
  for (std::size_t i = 0; error_.empty() && i < count; ++i) {
    all[i] = numberIn((*list)[i], false).value_or(std::nan(""));
    if (!(all[i] >= low && all[i] <= high))
      setError("needs numbers from " + shownRange(low, high) + " in the list '" + std::string(key) + "', not " +
               shown((*list)[i]) + ".");
  }
  return error_.empty() ? all : std::vector<double>(count);
}

double JsonEntry::number(std::string_view key, double low, double high) {
  return find(key, true) ? optionalNumber(key, low, high).value_or(0) : 0;
}

std::optional<int> JsonEntry::optionalInteger(std::string_view key, int low, int high) {
  const std::optional<double> value = optionalNumber(key, low, high);
  if (value && *value != std::floor(*value))
    setError("needs a whole number as '" + std::string(key) + "', not " + shown(*value) + ".");
  return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

int JsonEntry::integer(std::string_view key, int low, int high) {
  return find(key, true) ? optionalInteger(key, low, high).value_or(low) : low;
}

bool JsonEntry::has(std::string_view key) const {
  return object_.is_object() && object_.contains(key);
}

bool JsonEntry::flag(std::string_view key) {
  const json* value = find(key, false);
  if (!value) return false;
  if (!value->is_boolean()) setError("needs true or false as '" + std::string(key) + "', not " + shown(*value) + ".");
  return value->is_boolean() && value->get<bool>();
}

std::size_t JsonEntry::word(std::string_view key, const std::vector<std::string_view>& words) {
  const json* value = find(key, false);
  const std::string chosen = value && value->is_string() ? value->get<std::string>() : "";
  const auto found = std::ranges::find(words, chosen);
  if (value && found != words.end()) return static_cast<std::size_t>(found - words.begin());
  if (!value)
    setError("has no '" + std::string(key) + "'; it is one of " + joinedWords(words) + ".");
  else if (chosen.empty())
    setError("needs one of " + joinedWords(words) + " as '" + std::string(key) + "', not " + shown(*value) + ".");
  else
    setError("has the unknown " + std::string(key) + " '" + chosen + "'" + didYouMean(chosen, words));
  return 0;
}

const json& JsonEntry::array(std::string_view key) {
  static const json kNone = json::array();
  const json* value = find(key, false);
  if (value && !value->is_array())
    setError("needs a list [ ... ] as '" + std::string(key) + "', not " + shown(*value) + ".");
  return value && value->is_array() ? *value : kNone;
}

std::vector<std::string> JsonEntry::texts(std::string_view key) {
  std::vector<std::string> all;
  for (const json& entry : array(key)) {
    if (!entry.is_string() || entry.get_ref<const std::string&>().empty())
      setError("needs texts in the list '" + std::string(key) + "', not " + shown(entry) + ".");
    else
      all.push_back(entry);
  }
  return all;
}

void JsonEntry::forEach(std::string_view key, const std::string& noun, const Reader& read, bool namesDiffer) {
  std::set<std::string> names;
  int number = 0;
  for (const json& entry : array(key)) {
    ++number;
    const bool isNamed = entry.is_object() && entry.contains("name") && entry["name"].is_string();
    const std::string name = isNamed ? entry["name"].get<std::string>() : "";
    const std::string where = noun + " " + (name.empty() ? std::to_string(number) : "'" + name + "'");
    std::string error;
    read(entry, where, error);
    if (error.empty() && !name.empty() && namesDiffer && !names.insert(name).second)
      error = where + " occurs twice. Give each a different name.";
    if (!error.empty()) return setError("cannot be used: " + error);
  }
}

const json& JsonEntry::value(std::string_view key) {
  static const json kNone = json::object();
  const json* value = find(key, true);
  return value ? *value : kNone;
}

}  // namespace insonate
