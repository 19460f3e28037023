#pragma once

#include "StepFields.h"

#include <insonate/core/JsonEntry.h>

#include <nlohmann/json.hpp>

namespace insonate::segmentation {

/// Source of a step's points: given in the step itself, or taken later from the clicks of a guide.
enum class Points { kGiven, kLater };

/// Reads a step's fields from its JSON object; the first error is kept as a sentence.
class StepReader {
 public:
  StepReader(const nlohmann::json& object, const std::string& where, const std::vector<std::string_view>& known,
             Points points, std::string& error)
      : object_(object), entry_(object, where, known, error), points_(points) {}

  void operator()(const char* key, double& value, double low, double high);
  void operator()(const char* key, int& value, int low, int high);
  void operator()(const char* key, std::optional<int>& value, int low, int high);
  void operator()(const char* key, bool& value);
  void operator()(const char* key, std::string& value) {
    if (entry_.has(key)) value = entry_.text(key);
  }
  void operator()(const char* key, HuRange& value);
  void operator()(const char* key, std::optional<HuRange>& value);
  void operator()(const char* key, std::uint8_t& label);
  void operator()(const char* key, std::vector<std::uint8_t>& labels);
  void operator()(const char* key, std::optional<std::vector<std::uint8_t>>& labels);
  void operator()(const char* key, std::vector<Vec3>& points_mm, std::size_t least);
  void operator()(const char* key, Vec3& direction);
  void operator()(const char* key, std::optional<Vec3>& point_mm);
  void operator()(const char* key, std::optional<std::array<Vec3, 2>>& corners_mm);
  template <class Enumeration>
  void operator()(const char* key, Enumeration& value, const Words& words) {
    if (entry_.has(key)) value = static_cast<Enumeration>(entry_.word(key, words));
  }

  void setError(const std::string& sentence) { entry_.setError(sentence); }

 private:
  std::optional<std::uint8_t> labelIn(const nlohmann::json& value, const char* key);
  std::optional<Vec3> pointIn(const nlohmann::json& value);
  std::vector<Vec3> pointsIn(const char* key);

  const nlohmann::json& object_;
  JsonEntry entry_;
  Points points_;
};

}  // namespace insonate::segmentation
