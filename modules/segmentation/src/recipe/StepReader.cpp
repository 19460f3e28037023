#include "StepReader.h"

#include <insonate/core/Words.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>

namespace insonate::segmentation {
namespace {

using nlohmann::json;

constexpr double kFarthest_mm = 1e5;

}  // namespace

void StepReader::operator()(const char* key, double& value, double low, double high) {
  value = entry_.optionalNumber(key, low, high).value_or(value);
}

void StepReader::operator()(const char* key, int& value, int low, int high) {
  value = entry_.optionalInteger(key, low, high).value_or(value);
}

void StepReader::operator()(const char* key, std::optional<int>& value, int low, int high) {
  value = entry_.optionalInteger(key, low, high);
}

void StepReader::operator()(const char* key, bool& value) {
  if (entry_.has(key)) value = entry_.flag(key);
}

void StepReader::operator()(const char* key, std::optional<HuRange>& value) {
  if (!entry_.has(key)) return;
  const json& range = object_[key];
  if (!range.is_array() || range.size() != 2 || !range[0].is_number_integer() || !range[1].is_number_integer() ||
      range[0] > range[1] || range[0] < -32768 || range[1] > 32767)
    return entry_.setError("needs [from, to] in whole Hounsfield units from -32768 to 32767 as '" + std::string(key) +
                           "'.");
  value = HuRange{range[0], range[1]};
}

void StepReader::operator()(const char* key, HuRange& value) {
  std::optional<HuRange> range;
  (*this)(key, range);
  if (!entry_.has(key)) entry_.setError("has no '" + std::string(key) + "': [from, to] in Hounsfield units.");
  value = range.value_or(value);
}

std::optional<std::uint8_t> StepReader::labelIn(const json& value, const char* key) {
  if (value.is_number_integer() && value >= 0 && value < Proposal::kKeep) return value.get<std::uint8_t>();
  const std::string name = value.is_string() ? value.get<std::string>() : "";
  if (const auto label = labelFromName(name)) return *label;
  std::vector<std::string_view> names;
  for (const LabelInfo& info : labelTable()) names.push_back(info.name);
  const std::string_view near = nearestWord(name, names);
  entry_.setError(
      "needs labels of the table or numbers from 0 to 254 as '" + std::string(key) + "'" +
      (name.empty() ? std::string() : ", not '" + name + "'") +
      (near.empty() ? "; names are " + quotedWords(names) + "." : "; did you mean '" + std::string(near) + "'?"));
  return std::nullopt;
}

void StepReader::operator()(const char* key, std::uint8_t& label) {
  if (!entry_.has(key)) return;
  if (object_[key] == kSurroundingsWord)
    label = LabelStep::kSurroundings;
  else
    label = labelIn(object_[key], key).value_or(label);
}

void StepReader::operator()(const char* key, std::optional<std::vector<std::uint8_t>>& labels) {
  if (!entry_.has(key)) return;
  const json& list = object_[key];
  if (!list.is_array() || list.empty()) return entry_.setError("needs a list of labels as '" + std::string(key) + "'.");
  labels.emplace();
  for (const json& value : list)
    if (const auto label = labelIn(value, key)) labels->push_back(*label);
}

void StepReader::operator()(const char* key, std::vector<std::uint8_t>& labels) {
  std::optional<std::vector<std::uint8_t>> list;
  (*this)(key, list);
  if (list) labels = std::move(*list);
}

std::optional<Vec3> StepReader::pointIn(const json& value) {
  const bool isPoint = value.is_array() && value.size() == 3 && std::ranges::all_of(value, [](const json& c) {
                         return c.is_number() && c >= -kFarthest_mm && c <= kFarthest_mm;
                       });
  if (!isPoint) return std::nullopt;
  return Vec3{value[0], value[1], value[2]};
}

std::vector<Vec3> StepReader::pointsIn(const char* key) {
  std::vector<Vec3> points;
  const json& list = object_[key];
  for (const json& value : list) {
    const auto point = list.is_array() ? pointIn(value) : std::nullopt;
    if (!point) return {};
    points.push_back(*point);
  }
  return points;
}

void StepReader::operator()(const char* key, std::vector<Vec3>& points_mm, std::size_t least) {
  if (entry_.has(key)) points_mm = pointsIn(key);
  if (points_mm.size() < least && (points_ == Points::kGiven || entry_.has(key)))
    entry_.setError("needs a list of " + std::to_string(least) + " or more points [x, y, z] of the patient in mm as '" +
                    key + "'.");
}

void StepReader::operator()(const char* key, std::optional<Vec3>& point_mm) {
  if (!entry_.has(key)) return;
  point_mm = pointIn(object_[key]);
  if (!point_mm) entry_.setError("needs a point [x, y, z] of the patient in mm as '" + std::string(key) + "'.");
}

void StepReader::operator()(const char* key, Vec3& direction) {
  std::optional<Vec3> given;
  if (entry_.has(key)) given = pointIn(object_[key]);
  if (given && norm(*given) > 1e-6)
    direction = normalized(*given);
  else
    entry_.setError("needs a direction [x, y, z] in the patient as '" + std::string(key) + "'.");
}

void StepReader::operator()(const char* key, std::optional<std::array<Vec3, 2>>& corners_mm) {
  if (!entry_.has(key)) return;
  const auto points = pointsIn(key);
  if (points.size() != 2)
    return entry_.setError("needs two corners [[x, y, z], [x, y, z]] in mm as '" + std::string(key) + "'.");
  corners_mm = {points[0], points[1]};
}

}  // namespace insonate::segmentation
