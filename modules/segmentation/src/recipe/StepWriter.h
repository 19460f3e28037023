#pragma once

#include "StepFields.h"

#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

namespace insonate::segmentation {

/// Writes a step's fields to a JSON object, as StepReader reads them.
class StepWriter {
 public:
  explicit StepWriter(nlohmann::json& object) : object_(object) {}

  template <class Number>
  requires std::is_arithmetic_v<Number>
  void operator()(const char* key, Number value, Number, Number) { object_[key] = value; }
  void operator()(const char* key, double value, double, double) { object_[key] = value; }
  void operator()(const char* key, bool value) { object_[key] = value; }
  void operator()(const char* key, const std::string& value) {
    if (!value.empty()) object_[key] = value;
  }
  void operator()(const char* key, std::uint8_t label) { object_[key] = text(label); }
  void operator()(const char* key, const HuRange& range) { object_[key] = {range.low, range.high}; }
  void operator()(const char* key, Vec3 direction) { object_[key] = text(direction); }
  void operator()(const char* key, const std::vector<std::uint8_t>& labels) {
    for (const std::uint8_t label : labels) object_[key].push_back(text(label));
  }
  void operator()(const char* key, const std::vector<Vec3>& points_mm, std::size_t = 0) {
    for (const Vec3& point_mm : points_mm) object_[key].push_back(text(point_mm));
  }
  void operator()(const char* key, const std::array<Vec3, 2>& corners_mm) {
    object_[key] = {text(corners_mm[0]), text(corners_mm[1])};
  }
  template <class Enumeration>
  requires std::is_enum_v<Enumeration>
  void operator()(const char* key, Enumeration value, const Words& words) {
    object_[key] = words[static_cast<std::size_t>(value)];
  }
  template <class Value, class... Rest>
  void operator()(const char* key, const std::optional<Value>& value, Rest... rest) {
    if (value) (*this)(key, *value, rest...);
  }

 private:
  static nlohmann::json text(Vec3 v) { return {v.x, v.y, v.z}; }
  static nlohmann::json text(std::uint8_t label) {
    if (label == LabelStep::kSurroundings) return kSurroundingsWord;
    if (label < kLabelCount) return labelName(label);
    return label;
  }

  nlohmann::json& object_;
};

}  // namespace insonate::segmentation
