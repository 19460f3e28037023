#include "FormerProbe.h"
#include "JsonFields.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/core/Words.h>
#include <insonate/embedded/probes.h>
#include <insonate/ultrasound/SetupText.h>

#include <nlohmann/json.hpp>

#include <array>

namespace insonate {
namespace {

using Field = ProbeField;
using Use = ProbeField::Use;

constexpr std::array kFields{
    Field{"width_mm", &Probe::width_mm, 5, 200, Use::Linear},
    Field{"fovAngle_deg", &Probe::fovAngle_deg, 10, 150, Use::Fan},
    Field{"faceRadius_mm", &Probe::faceRadius_mm, 0, 200, Use::Fan},
    Field{"minFrequency_MHz", &Probe::minFrequency_MHz, 0.5, 50},
    Field{"maxFrequency_MHz", &Probe::maxFrequency_MHz, 0.5, 50},
    Field{"defaultFrequency_MHz", &Probe::defaultFrequency_MHz, 0.5, 50},
    Field{"minDepth_mm", &Probe::minDepth_mm, 5, 400},
    Field{"maxDepth_mm", &Probe::maxDepth_mm, 5, 400},
    Field{"defaultDepth_mm", &Probe::defaultDepth_mm, 5, 400},
    Field{"defaultFocus_mm", &Probe::defaultFocus_mm, 1, 400},
    Field{"pitch_mm", &Probe::pitch_mm, 0.05, 2},
    Field{"bandwidth", &Probe::bandwidth, 0.1, 1.5},
    Field{"transmitFNumber", &Probe::transmitFNumber, 0.5, 20},
    Field{"receiveFNumber", &Probe::receiveFNumber, 0.5, 20},
    Field{"maxAperture_mm", &Probe::maxAperture_mm, 1, 200},
    Field{"elementHeight_mm", &Probe::elementHeight_mm, 1, 40},
    Field{"elevationFocus_mm", &Probe::elevationFocus_mm, 1, 400},
};

const std::vector<std::string_view> kShapes{"linear", "curvilinear", "phased"};
const std::vector<std::string_view> kApodizations{"uniform", "tukey", "hann"};

Result<void> checkOrder(double low, double middle, double high, std::string_view quantity, const std::string& where) {
  if (low <= middle && middle <= high) return {};
  return fail(where + ": the default " + std::string(quantity) + " must lie between its minimum and maximum.");
}

Result<Probe> probeFromJson(const nlohmann::json& file, const std::string& source) {
  const std::string where = "probe " + source;
  const auto converted = withFormerNames(file, where);
  if (!converted) return tl::unexpected(converted.error());
  const nlohmann::json& json = *converted;
  std::vector<std::string_view> known{"name", "shape", "apodization"};
  for (const Field& field : kFields) known.push_back(field.name);
  if (auto ok = fields::checkKeys(json, known, where); !ok) return tl::unexpected(ok.error());
  for (const std::string_view name : {"name", "shape", "apodization"})
    if (!json.contains(name)) return fail(where + ": '" + std::string(name) + "' is missing.");

  Probe probe;
  if (!json["name"].is_string()) return fail(where + ": name must be text.");
  probe.name = json["name"].get<std::string>();
  const auto shape = fields::readChoice(json["shape"], kShapes, "shape", where);
  if (!shape) return tl::unexpected(shape.error());
  probe.shape = static_cast<ProbeShape>(*shape);
  const auto apodization = fields::readChoice(json["apodization"], kApodizations, "apodization", where);
  if (!apodization) return tl::unexpected(apodization.error());
  probe.apodization = static_cast<Apodization>(*apodization);
  for (const Field& field : kFields) {
    const std::string name(field.name);
    if (!applies(field, probe.shape)) {
      if (json.contains(name))
        return fail(where + ": " + name + " has no meaning for a " + json["shape"].get<std::string>() +
                    " probe; leave it out.");
      continue;
    }
    if (!json.contains(name)) return fail(where + ": '" + name + "' is missing.");
    const auto value = fields::readNumber(json[name], name, where);
    if (!value) return tl::unexpected(value.error());
    probe.*field.member = *value;
  }
  if (auto ok = validate(probe); !ok) return tl::unexpected(ok.error());
  return probe;
}

}  // namespace

std::span<const ProbeField> probeFields() {
  return kFields;
}

bool applies(const ProbeField& field, ProbeShape shape) {
  return field.use == Use::Always || (field.use == Use::Linear) == (shape == ProbeShape::Linear);
}

std::vector<std::string> probePresetNames() {
  std::vector<std::string> names;
  for (const auto& file : embedded::probes::files()) names.emplace_back(file.name);
  return names;
}

Result<Probe> loadProbe(std::string_view nameOrPath) {
  std::vector<std::string_view> presets;
  for (const auto& file : embedded::probes::files()) {
    presets.push_back(file.name);
    if (file.name != nameOrPath) continue;
    const auto json = fields::parseText(file.text, "preset " + std::string(file.name));
    if (!json) return tl::unexpected(json.error());
    return probeFromJson(*json, std::string(file.name));
  }
  const std::filesystem::path path(nameOrPath);
  std::error_code error;
  if (nameOrPath.empty() || !std::filesystem::exists(path, error))
    return fail("there is no probe preset and no file named '" + std::string(nameOrPath) + "'; presets are " +
                joinedWords(presets) + ".");
  const auto json = fields::parseFile(path);
  if (!json) return tl::unexpected(json.error());
  return probeFromJson(*json, path.string());
}

Result<Probe> parseProbe(std::string_view text) {
  const auto json = fields::parseText(text, "the probe");
  if (!json) return tl::unexpected(json.error());
  return probeFromJson(*json, "of the text");
}

std::string textOf(const Probe& probe) {
  nlohmann::ordered_json json{{"name", probe.name},
                              {"shape", kShapes[std::size_t(probe.shape)]},
                              {"apodization", kApodizations[std::size_t(probe.apodization)]}};
  for (const Field& field : kFields)
    if (applies(field, probe.shape)) json[std::string(field.name)] = probe.*field.member;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Result<void> saveProbe(const Probe& probe, const std::filesystem::path& file) {
  if (auto ok = validate(probe); !ok) return ok;
  return writeAtomically(file, textOf(probe));
}

Result<void> validate(const Probe& probe) {
  const std::string where = "probe '" + probe.name + "'";
  if (probe.name.empty()) return fail("the probe has no name; give it one.");
  for (const Field& field : kFields) {
    if (!applies(field, probe.shape)) continue;
    if (auto ok = fields::checkRange(probe.*field.member, field.low, field.high, field.name, where); !ok) return ok;
  }
  if (probe.shape == ProbeShape::Curvilinear)
    if (auto ok = fields::checkRange(probe.faceRadius_mm, 5, 200, "faceRadius_mm", where); !ok) return ok;
  if (auto ok =
          checkOrder(probe.minFrequency_MHz, probe.defaultFrequency_MHz, probe.maxFrequency_MHz, "frequency", where);
      !ok)
    return ok;
  return checkOrder(probe.minDepth_mm, probe.defaultDepth_mm, probe.maxDepth_mm, "depth", where);
}

}  // namespace insonate
