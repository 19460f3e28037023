#include "NumberNames.h"

#include "ItkSnapLabels.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

std::optional<std::int32_t> numberIn(std::string_view text) {
  std::int32_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && rest == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

std::string textOf(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// dcmqi: a list of files, each a list of segments.
void addSegmentAttributes(const json& files, NumberNames& names) {
  for (const json& file : files)
    for (const json& segment : file.is_array() ? file : json::array()) {
      if (!segment.is_object()) continue;
      const auto number = segment.find("labelID");
      if (number == segment.end() || !number->is_number_integer()) continue;
      const json type = segment.value("SegmentedPropertyTypeCodeSequence", json::object());
      std::string name = textOf(segment, "SegmentLabel");
      if (name.empty()) name = textOf(segment, "SegmentDescription");
      if (name.empty() && type.is_object()) name = textOf(type, "CodeMeaning");
      names[number->get<std::int32_t>()] = {name, type.is_object() ? textOf(type, "CodeValue") : std::string()};
    }
}

/// nnU-Net: numbers by name, or, in its first version, names by number.
void addLabels(const json& labels, NumberNames& names) {
  for (const auto& [key, value] : labels.items()) {
    if (value.is_number_integer())
      names[value.get<std::int32_t>()] = {key};
    else if (const auto number = numberIn(key); number && value.is_string())
      names[*number] = {value.get<std::string>()};
  }
}

/// A bundle of MONAI names the channels of its result; a channel is a number in the label map.
void addChannels(const json& bundle, NumberNames& names) {
  const json::json_pointer place("/outputs/pred/channel_def");
  if (bundle.contains(place) && bundle[place].is_object()) addLabels(bundle[place], names);
}

/// A label dictionary of MONAI contains only numbers by name, or names by number.
bool isDictionary(const json& content) {
  if (!content.is_object() || content.contains("labels") || content.contains("segmentAttributes")) return false;
  const auto items = content.items();
  return std::all_of(items.begin(), items.end(), [](const auto& item) {
    return item.value().is_number_integer() || (numberIn(item.key()) && item.value().is_string());
  });
}

Result<NumberNames> readJson(const fs::path& file) {
  std::ifstream in(file);
  const json content = json::parse(in, nullptr, false);
  NumberNames names;
  const auto part = [&content](const char* key) { return content.is_object() ? content.value(key, json()) : json(); };
  if (const json files = part("segmentAttributes"); files.is_array())
    addSegmentAttributes(files, names);
  else if (const json labels = part("labels"); labels.is_object())
    addLabels(labels, names);
  else if (const json bundle = part("network_data_format"); bundle.is_object())
    addChannels(bundle, names);
  else if (isDictionary(content))
    addLabels(content, names);
  names.erase(0);
  return names;
}

/// Lines "number name red green blue alpha"; a name has "_" for its spaces.
NumberNames readColorTable(const fs::path& file) {
  std::ifstream in(file);
  NumberNames names;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::int32_t number = 0;
    NumberName entry;
    std::array<int, 3> color{};
    if (!(words >> number >> entry.name >> color[0] >> color[1] >> color[2])) continue;
    entry.color.emplace();
    for (int c = 0; c < 3; ++c) (*entry.color)[c] = static_cast<std::uint8_t>(color[c]);
    names[number] = std::move(entry);
  }
  return names;
}

Result<NumberNames> readDescription(const fs::path& file) {
  const auto described = readItkSnapLabels(file);
  if (!described) return tl::unexpected(described.error());
  NumberNames names;
  for (const auto& [number, label] : *described) names[number] = {label.name, {}, label.color};
  return names;
}

}  // namespace

Result<NumberNames> readNumberNames(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return fail("Could not read the names of labels in " + file.string() + ".");
  if (file.extension() != ".json" && file.extension() != ".ctbl") return readDescription(file);
  auto names = file.extension() == ".json" ? readJson(file) : readColorTable(file);
  if (names && names->empty())
    return fail(file.string() +
                " names no labels. Choose a label description of ITK-SNAP, a color table of 3D Slicer (.ctbl), or a "
                "JSON file of dcmqi, nnU-Net or MONAI.");
  return names;
}

NumberNames namesInExtension(std::string_view text) {
  constexpr std::string_view kEntry = "<Label ", kKey = "Key=\"", kOpen = "<![CDATA[", kClose = "]]>";
  NumberNames names;
  for (std::size_t at = text.find(kEntry); at != text.npos; at = text.find(kEntry, at + kEntry.size())) {
    const std::string_view entry = text.substr(at, text.find("</Label>", at) - at);
    const std::size_t key = entry.find(kKey), open = entry.find(kOpen), close = entry.find(kClose);
    if (key == entry.npos || open == entry.npos || close == entry.npos || close < open) continue;
    const std::string_view digits = entry.substr(key + kKey.size());
    const auto number = numberIn(digits.substr(0, digits.find('"')));
    const std::size_t first = open + kOpen.size();
    if (number && first < close) names[*number] = {std::string(entry.substr(first, close - first))};
  }
  return names;
}

}  // namespace insonate
