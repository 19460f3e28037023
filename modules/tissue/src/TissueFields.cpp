#include "TissueFields.h"

#include <insonate/core/Words.h>

#include <algorithm>
#include <array>

namespace insonate::tissuefile {
namespace {

using nlohmann::json;

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

constexpr std::array<std::string_view, 6> kTextures{"none", "septa", "lobules", "sheets", "fine", "bundles"};

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

Result<void> readTissue(const json& entry, bool complete, const std::string& where, AcousticTissue& tissue) {
  const auto known = namesOf(kTissueFields, {"label", "texture", "vessel", "gas", "layers"});
  return checkKeys(entry, known, where)
      .and_then([&] { return readNumbers(entry, kTissueFields, complete, where, tissue); })
      .and_then([&] { return readTexture(entry, where, tissue.texture); })
      .and_then([&] { return readSwitch(entry, "vessel", where, tissue.vessel); })
      .and_then([&] { return readSwitch(entry, "gas", where, tissue.gas); })
      .and_then([&] { return readLayers(entry, where, tissue.layers); });
}

json written(const AcousticTissue& tissue) {
  json entry{{"texture", kTextures[static_cast<std::size_t>(tissue.texture)]},
             {"vessel", tissue.vessel},
             {"gas", tissue.gas},
             {"layers", json::array()}};
  writeNumbers(tissue, kTissueFields, entry);
  for (const BoundaryLayer& layer : tissue.layers) {
    json item = json::object();
    writeNumbers(layer, kLayerFields, item);
    entry["layers"].push_back(std::move(item));
  }
  return entry;
}

}  // namespace insonate::tissuefile
