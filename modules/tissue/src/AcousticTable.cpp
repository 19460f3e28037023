#include "NumberFields.h"
#include "TableFile.h"

#include <insonate/embedded/tissues.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/TableText.h>

#include <string>

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

BoundaryLayer readLayer(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, presetNames(kLayerFields, {"name"}), error);
  BoundaryLayer layer;
  readNumbers(entry, kLayerFields, true, layer);
  if (!(layer.from_mm < layer.to_mm)) entry.setError("needs a 'from_mm' below its 'to_mm'.");
  return layer;
}

/// Fills `tissue` from an entry of "tissues". With `complete`, every number has to be there; without, the missing ones
/// stay as they are.
void readTissue(const json& object, bool complete, const std::string& where, std::string& error,
                AcousticTissue& tissue) {
  JsonEntry entry(object, where, presetNames(kTissueFields, {"label", "texture", "vessel", "gas", "layers"}), error);
  readNumbers(entry, kTissueFields, complete, tissue);
  if (entry.has("texture"))
    tissue.texture = static_cast<Texture>(entry.word("texture", {kTextures.begin(), kTextures.end()}));
  if (entry.has("vessel")) tissue.vessel = entry.flag("vessel");
  if (entry.has("gas")) tissue.gas = entry.flag("gas");
  if (entry.has("layers")) tissue.layers = entry.list("layers", where + ", layer", readLayer, false);
  if (tissue.layers.size() > kMaxBoundaryLayers)
    entry.setError("has more 'layers' than " + std::to_string(kMaxBoundaryLayers) + ".");
}

/// Inverse of readTissue(), complete.
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

}  // namespace
}  // namespace insonate::tissuefile

namespace insonate {
namespace {

const tissuefile::TableForm<AcousticTable>& acousticForm() {
  static const tissuefile::TableForm<AcousticTable> all{"tissue", embeddedPresets(embedded::tissues::files()),
                                                        tissuefile::readTissue};
  return all;
}

}  // namespace

std::vector<std::string> acousticPresetNames() {
  return presetNames(acousticForm().presets);
}

Result<AcousticTable> parseAcousticTable(std::string_view text) {
  return tissuefile::parseTable(text, acousticForm());
}

Result<AcousticTable> loadAcousticTable(std::string_view nameOrPath) {
  return tissuefile::loadTable(nameOrPath, acousticForm());
}

std::string textOf(const AcousticTable& table) {
  return tissuefile::tableText(table, tissuefile::written);
}

}  // namespace insonate
