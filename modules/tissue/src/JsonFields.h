#pragma once

#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

/// Numbers and labels in the files of resources/tissues and resources/mechanics. `where` opens each sentence:
/// "tissue 'fat'".
namespace insonate::tissuefile {

/// Permitted values in a file; the narrower "range" beside a value states how well that value is known.
struct Limits {
  double low = 0, high = 0;
  bool infinite = false;  ///< "infinity" is allowed, too
};

template <class T>
struct Field {
  std::string_view name;
  double T::*member;
  double low, high;
  bool infinite = false;
};

/// A value of a file for a sentence, cut if it is long.
std::string shown(const nlohmann::json& value);
std::string shown(double value);

/// A plain number, or {"value": .., "range": [.., ..], "source": ".."}. `what` names tissue and field.
Result<double> readNumber(const nlohmann::json& entry, const Limits& limits, const std::string& what);

/// The fields that an object has; with `complete`, all have to be there.
template <class T, std::size_t N>
Result<void> readNumbers(const nlohmann::json& object, const std::array<Field<T>, N>& all, bool complete,
                         const std::string& where, T& target) {
  for (const Field<T>& field : all) {
    const auto found = object.find(field.name);
    if (found == object.end()) {
      if (complete) return fail(where + ": " + std::string(field.name) + " is missing.");
      continue;
    }
    const auto value =
        readNumber(*found, {field.low, field.high, field.infinite}, where + ": " + std::string(field.name));
    if (!value) return tl::unexpected(value.error());
    target.*field.member = *value;
  }
  return {};
}

/// Inverse of readNumbers().
template <class T, std::size_t N>
void writeNumbers(const T& from, const std::array<Field<T>, N>& all, nlohmann::json& object) {
  for (const Field<T>& field : all) {
    const double value = from.*field.member;
    object[std::string(field.name)] = std::isinf(value) ? nlohmann::json("infinity") : nlohmann::json(value);
  }
}

template <class T, std::size_t N>
std::vector<std::string_view> namesOf(const std::array<Field<T>, N>& all, std::vector<std::string_view> names) {
  for (const Field<T>& field : all) names.push_back(field.name);
  return names;
}

/// The entry's "label": a name or number of insonate/tissue/Labels.h.
Result<Label> readLabel(const nlohmann::json& entry);

/// Refuses anything but an object with known keys.
Result<void> checkKeys(const nlohmann::json& object, const std::vector<std::string_view>& known,
                       const std::string& where);

}  // namespace insonate::tissuefile
