#pragma once

#include <insonate/core/JsonEntry.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

/// Reads and writes the numbers of a tissue in the files of resources/tissues, resources/mechanics and
/// resources/haptics.
namespace insonate::tissuefile {

/// Name, member and permitted range of a numeric field. (The "range" beside a value in a file is different: it is
/// narrower and states the value's uncertainty.)
template <class T>
struct Field {
  std::string_view name;
  double T::*member;
  double low, high;
  bool allowInfinity = false;
};

/// Reads the fields that are present in an entry; with `complete`, a missing field is an error.
template <class T, std::size_t N>
void readNumbers(JsonEntry& entry, const std::array<Field<T>, N>& all, bool complete, T& target) {
  for (const Field<T>& field : all) {
    const auto value = entry.optionalNumberWithSource(field.name, field.low, field.high, field.allowInfinity);
    if (complete && !entry.has(field.name)) entry.setError("has no '" + std::string(field.name) + "'.");
    target.*field.member = value.value_or(target.*field.member);
  }
}

/// Writes all fields to a JSON object, as readNumbers() reads them.
template <class T, std::size_t N>
void writeNumbers(const T& from, const std::array<Field<T>, N>& all, nlohmann::json& object) {
  for (const Field<T>& field : all) {
    const double value = from.*field.member;
    object[std::string(field.name)] = std::isinf(value) ? nlohmann::json("infinity") : nlohmann::json(value);
  }
}

template <class T, std::size_t N>
std::vector<std::string_view> presetNames(const std::array<Field<T>, N>& all, std::vector<std::string_view> names) {
  for (const Field<T>& field : all) names.push_back(field.name);
  return names;
}

}  // namespace insonate::tissuefile
