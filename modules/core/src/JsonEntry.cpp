#include <insonate/core/JsonEntry.h>
#include <insonate/core/Words.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace insonate {
namespace {

using nlohmann::json;

std::string shown(const json& value) {
  constexpr std::size_t kMost = 40;
  if (value.is_structured() && !value.empty()) return value.is_array() ? "[ ... ]" : "{ ... }";
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string didYouMean(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view near = nearestWord(word, known);
  return near.empty() ? "; it is one of " + joinedWords(known) + "." : "; did you mean '" + std::string(near) + "'?";
}

}  // namespace

JsonEntry::JsonEntry(const json& object, std::string where, const std::vector<std::string_view>& known)
    : object_(object), where_(std::move(where)) {
  if (!object.is_object()) {
    refuse("must be an object { ... }, not " + shown(object) + ".");
    return;
  }
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(known, key) == known.end()) refuse("has an unknown '" + key + "'" + didYouMean(key, known));
}

void JsonEntry::refuse(const std::string& sentence) {
  if (trouble_.empty()) trouble_ = where_ + " " + sentence;
}

const json* JsonEntry::find(const char* key, bool needed) {
  if (!trouble_.empty()) return nullptr;
  const auto found = object_.find(key);
  if (found != object_.end()) return &*found;
  if (needed) refuse("has no '" + std::string(key) + "'.");
  return nullptr;
}

std::string JsonEntry::text(const char* key, bool needed) {
  const json* value = find(key, needed);
  if (!value) return {};
  const std::string text = value->is_string() ? value->get<std::string>() : std::string();
  if (!text.empty() && text.find('\0') == std::string::npos) return text;
  if (!text.empty())
    refuse("holds a zero byte (\\u0000) in its '" + std::string(key) + "'; remove it.");
  else
    refuse("needs a text as '" + std::string(key) + "', not " + shown(*value) + ".");
  return {};
}

std::optional<double> JsonEntry::numberIfThere(const char* key, double low, double high) {
  const json* value = find(key, false);
  if (!value) return std::nullopt;
  if (value->is_number() && *value >= low && *value <= high) return value->get<double>();
  refuse("needs a number from " + shown(low) + " to " + shown(high) + " as '" + key + "', not " + shown(*value) + ".");
  return std::nullopt;
}

double JsonEntry::number(const char* key, double low, double high) {
  return find(key, true) ? numberIfThere(key, low, high).value_or(0) : 0;
}

std::optional<int> JsonEntry::wholeIfThere(const char* key, int low, int high) {
  const std::optional<double> value = numberIfThere(key, low, high);
  if (value && *value != std::floor(*value))
    refuse("needs a whole number as '" + std::string(key) + "', not " + shown(*value) + ".");
  return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

int JsonEntry::whole(const char* key, int low, int high) {
  return find(key, true) ? wholeIfThere(key, low, high).value_or(low) : low;
}

bool JsonEntry::has(const char* key) const {
  return object_.is_object() && object_.contains(key);
}

bool JsonEntry::flag(const char* key) {
  const json* value = find(key, false);
  if (!value) return false;
  if (!value->is_boolean()) refuse("needs true or false as '" + std::string(key) + "', not " + shown(*value) + ".");
  return value->is_boolean() && value->get<bool>();
}

std::size_t JsonEntry::word(const char* key, const std::vector<std::string_view>& words) {
  const std::string chosen = text(key);
  const auto found = std::ranges::find(words, chosen);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  refuse("has the unknown " + std::string(key) + " '" + chosen + "'" + didYouMean(chosen, words));
  return 0;
}

const json& JsonEntry::array(const char* key) {
  static const json kNone = json::array();
  const json* value = find(key, false);
  if (value && !value->is_array())
    refuse("needs a list [ ... ] as '" + std::string(key) + "', not " + shown(*value) + ".");
  return value && value->is_array() ? *value : kNone;
}

std::vector<std::string> JsonEntry::texts(const char* key) {
  std::vector<std::string> all;
  for (const json& entry : array(key)) {
    if (!entry.is_string() || entry.get_ref<const std::string&>().empty())
      refuse("needs texts in the list '" + std::string(key) + "', not " + shown(entry) + ".");
    else
      all.push_back(entry);
  }
  return all;
}

void JsonEntry::each(const char* key, const std::string& noun, const Reader& read) {
  std::set<std::string> names;
  int number = 0;
  for (const json& entry : array(key)) {
    ++number;
    const bool named = entry.is_object() && entry.contains("name") && entry["name"].is_string();
    const std::string name = named ? entry["name"].get<std::string>() : "";
    const std::string where = noun + " " + (named ? "'" + name + "'" : std::to_string(number));
    std::string trouble;
    read(entry, where, trouble);
    if (trouble.empty() && named && !names.insert(name).second)
      trouble = where + " is there twice; names tell them apart.";
    if (!trouble.empty()) return refuse("cannot be used: " + trouble);
  }
}

const json& JsonEntry::object(const char* key) {
  static const json kNone = json::object();
  const json* value = find(key, true);
  return value ? *value : kNone;
}

}  // namespace insonate
