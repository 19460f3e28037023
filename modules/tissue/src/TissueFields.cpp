#include "TissueFields.h"

#include <insonate/core/Words.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace insonate::tissuefile {
namespace {

using nlohmann::json;

/// What a file may say; the narrower "range" beside a value tells how well that value is known.
template <class T>
struct Field {
  std::string_view name;
  double T::*member;
  double low, high;
};

constexpr std::array kTissueFields{
    Field<AcousticTissue>{"impedance_MRayl", &AcousticTissue::impedance_MRayl, 1e-4, 100},
    Field<AcousticTissue>{"attenuation_dBpcmMHz", &AcousticTissue::attenuation_dBpcmMHz, 0, 100},
    Field<AcousticTissue>{"attenuationExponent", &AcousticTissue::attenuationExponent, 0.5, 2},
    Field<AcousticTissue>{"echogenicity_dB", &AcousticTissue::echogenicity_dB, -120, 40},
    Field<AcousticTissue>{"ctImpedancePer100HU", &AcousticTissue::ctImpedancePer100HU, -0.2, 0.2},
    Field<AcousticTissue>{"ctEchogenicity_dBper100HU", &AcousticTissue::ctEchogenicity_dBper100HU, -20, 20},
    Field<AcousticTissue>{"specularExponent", &AcousticTissue::specularExponent, 0, 100},
    Field<AcousticTissue>{"specularDiffuse", &AcousticTissue::specularDiffuse, 0, 1},
    Field<AcousticTissue>{"roughness_dB", &AcousticTissue::roughness_dB, 0, 20},
    Field<AcousticTissue>{"textureStrength_dB", &AcousticTissue::textureStrength_dB, 0, 40},
};

constexpr std::array kLayerFields{
    Field<BoundaryLayer>{"from_mm", &BoundaryLayer::from_mm, -20, 20},
    Field<BoundaryLayer>{"to_mm", &BoundaryLayer::to_mm, -20, 20},
    Field<BoundaryLayer>{"echo_dB", &BoundaryLayer::echo_dB, -120, 60},
    Field<BoundaryLayer>{"anisotropy", &BoundaryLayer::anisotropy, 0, 1},
    Field<BoundaryLayer>{"patchiness", &BoundaryLayer::patchiness, 0, 1},
};

constexpr std::array<std::string_view, 5> kTextures{"none", "septa", "lobules", "sheets", "fine"};

std::string shown(const json& value) {
  const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string rangeOf(double low, double high) {
  return shown(low) + " to " + shown(high);
}

/// The range beside a value: two numbers in order, the value between them.
Result<void> checkStatedRange(const json& range, double value, const std::string& what) {
  const bool pair = range.is_array() && range.size() == 2 && range[0].is_number() && range[1].is_number();
  if (!pair || range[0].get<double>() > range[1].get<double>())
    return fail(what + ": range must be [low, high], not " + shown(range) + ".");
  if (value < range[0].get<double>() || value > range[1].get<double>())
    return fail(what + " is " + shown(value) + ", outside its own range " +
                rangeOf(range[0].get<double>(), range[1].get<double>()) + ".");
  return {};
}

template <class T>
Result<void> readNumber(const json& entry, const Field<T>& field, const std::string& where, T& target) {
  const std::string what = where + ": " + std::string(field.name);
  const bool annotated = entry.is_object();
  if (annotated) {
    if (auto ok = checkKeys(entry, {"value", "range", "source"}, what); !ok) return ok;
    if (!entry.contains("value")) return fail(what + " has no \"value\".");
    if (entry.contains("source") && !entry["source"].is_string())
      return fail(what + ": source must be a text, not " + shown(entry["source"]) + ".");
  }
  const json& number = annotated ? entry["value"] : entry;
  if (!number.is_number())
    return fail(what + " must be a number from " + rangeOf(field.low, field.high) + ", not " + shown(number) + ".");
  const double value = number.get<double>();
  if (!(value >= field.low && value <= field.high))
    return fail(what + " is " + shown(value) + "; allowed is " + rangeOf(field.low, field.high) + ".");
  if (annotated && entry.contains("range"))
    if (auto ok = checkStatedRange(entry["range"], value, what); !ok) return ok;
  target.*field.member = value;
  return {};
}

template <class T, std::size_t N>
Result<void> readNumbers(const json& object, const std::array<Field<T>, N>& all, bool complete,
                         const std::string& where, T& target) {
  for (const Field<T>& field : all) {
    const auto found = object.find(field.name);
    if (found == object.end()) {
      if (complete) return fail(where + ": " + std::string(field.name) + " is missing.");
      continue;
    }
    if (auto ok = readNumber(*found, field, where, target); !ok) return ok;
  }
  return {};
}

Result<void> readSwitch(const json& entry, const char* name, const std::string& where, bool& target) {
  const auto found = entry.find(name);
  if (found == entry.end()) return {};
  if (!found->is_boolean()) return fail(where + ": " + name + " must be true or false, not " + shown(*found) + ".");
  target = found->get<bool>();
  return {};
}

Result<void> readTexture(const json& entry, const std::string& where, Texture& target) {
  const auto found = entry.find("texture");
  if (found == entry.end()) return {};
  const auto choice =
      found->is_string() ? std::find(kTextures.begin(), kTextures.end(), found->get<std::string>()) : kTextures.end();
  if (choice == kTextures.end())
    return fail(where + ": texture must be one of " + joinedWords({kTextures.begin(), kTextures.end()}) + ", not " +
                shown(*found) + ".");
  target = static_cast<Texture>(choice - kTextures.begin());
  return {};
}

template <class T, std::size_t N>
std::vector<std::string_view> namesOf(const std::array<Field<T>, N>& all, std::vector<std::string_view> names) {
  for (const Field<T>& field : all) names.push_back(field.name);
  return names;
}

Result<void> readLayers(const json& entry, const std::string& where, std::vector<BoundaryLayer>& target) {
  const auto found = entry.find("layers");
  if (found == entry.end()) return {};
  if (!found->is_array() || found->size() > kMaxBoundaryLayers)
    return fail(where + ": layers must be a list of at most " + std::to_string(kMaxBoundaryLayers) + " objects.");
  std::vector<BoundaryLayer> layers;
  for (const json& item : *found) {
    const std::string here = where + ", layer " + std::to_string(layers.size() + 1);
    if (auto ok = checkKeys(item, namesOf(kLayerFields, {"name"}), here); !ok) return ok;
    BoundaryLayer layer;
    if (auto ok = readNumbers(item, kLayerFields, true, here, layer); !ok) return ok;
    if (!(layer.from_mm < layer.to_mm))
      return fail(here + ": from_mm is " + shown(layer.from_mm) + ", which must be below to_mm, " + shown(layer.to_mm) +
                  ".");
    layers.push_back(layer);
  }
  target = std::move(layers);
  return {};
}

}  // namespace

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

Result<void> readTissue(const json& entry, bool complete, const std::string& where, AcousticTissue& tissue) {
  const auto known = namesOf(kTissueFields, {"label", "texture", "vessel", "gas", "layers"});
  return checkKeys(entry, known, where)
      .and_then([&] { return readNumbers(entry, kTissueFields, complete, where, tissue); })
      .and_then([&] { return readTexture(entry, where, tissue.texture); })
      .and_then([&] { return readSwitch(entry, "vessel", where, tissue.vessel); })
      .and_then([&] { return readSwitch(entry, "gas", where, tissue.gas); })
      .and_then([&] { return readLayers(entry, where, tissue.layers); });
}

}  // namespace insonate::tissuefile
