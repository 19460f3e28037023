#include <insonate/core/AtomicFile.h>
#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/core/Range.h>
#include <insonate/embedded/probes.h>
#include <insonate/ultrasound/SetupText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string>

namespace insonate {
namespace {

constexpr std::array kFormerNames{"axialFwhm_wavelengths",     "lateralFNumber",
                                  "lateralDivergenceNear",     "lateralDivergenceFar",
                                  "elevationFwhm_wavelengths", "elevationDivergence"};
constexpr std::array kArrayNames{"pitch_mm",       "bandwidth",        "transmitFNumber",
                                 "receiveFNumber", "elementHeight_mm", "apodization"};

double pitchOf_mm(const nlohmann::json& shape) {
  return shape == "curvilinear" ? 0.508 : shape == "phased" ? 0.3 : 0.2;
}

/// A probe file as it is, or one that states widths of the beam, as files did until November 2026, by the array that
/// has these widths. Recordings and saved probes hold such files. `trouble` is set by one that is neither.
///
/// With the pulse's length p, the width w at the focus and the slice's t, all in wavelengths, and the lens at z:
/// bandwidth 0.441 / p (a Gaussian); receive F-number w / 1.733 and transmit F-number twice that, Hann (the law of
/// lateralFwhm_mm()); height 0.98 z / t (a strip at its focus); the pitch of the built-in probe of its shape. How fast
/// the former beam grew off its foci is left out: the array says it.
nlohmann::json withFormerNames(const nlohmann::json& file, const std::string& where, std::string& trouble) {
  const auto has = [&](const char* name) { return file.contains(name); };
  if (!file.is_object() || std::ranges::none_of(kFormerNames, has)) return file;
  JsonEntry entry(file, where, jsonKeys(file), trouble);
  for (const char* name : kArrayNames)
    if (has(name))
      entry.setError(std::string("has '") + name +
                     "', which describes the array and cannot be combined with widths such as '" +
                     *std::ranges::find_if(kFormerNames, has) + "'; leave out the widths.");
  const auto width = [&](const char* name) { return entry.number(name, 0.5, 400); };
  const double pulse = width("axialFwhm_wavelengths"), lateral = width("lateralFNumber");
  const double slice = width("elevationFwhm_wavelengths"), lens_mm = width("elevationFocus_mm");
  if (!trouble.empty()) return file;
  nlohmann::json array = file;
  for (const char* name : kFormerNames) array.erase(name);
  array["pitch_mm"] = pitchOf_mm(file.value("shape", nlohmann::json()));
  array["bandwidth"] = std::clamp(0.441 / pulse, 0.1, 1.5);
  array["receiveFNumber"] = std::clamp(lateral / 1.733, 0.5, 10.0);
  array["transmitFNumber"] = 2 * array["receiveFNumber"].get<double>();
  array["apodization"] = "hann";
  array["elementHeight_mm"] = std::clamp(0.98 * lens_mm / slice, 1.0, 40.0);
  return array;
}

using Field = ProbeField;
using Use = ProbeField::Use;

constexpr std::array kFields{
    Field{"width_mm", &Probe::width_mm, 5, 200, Use::Linear},
    Field{"faceMargin_mm", &Probe::faceMargin_mm, 0, 20, Use::Always, true},
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

Probe probeFrom(const nlohmann::json& file, std::string& trouble) {
  const std::string where = "The probe";
  const nlohmann::json json = withFormerNames(file, where, trouble);
  std::vector<std::string_view> known{"name", "shape", "apodization"};
  for (const Field& field : kFields) known.push_back(field.name);
  JsonEntry entry(json, where, known, trouble);
  Probe probe;
  probe.name = entry.text("name");
  probe.shape = static_cast<ProbeShape>(entry.word("shape", kShapes));
  probe.apodization = static_cast<Apodization>(entry.word("apodization", kApodizations));
  for (const Field& field : kFields) {
    if (applies(field, probe.shape)) {
      if (!field.optional || entry.has(field.name))
        probe.*field.member = entry.number(field.name, field.low, field.high);
    } else if (entry.has(field.name))
      entry.setError("has '" + std::string(field.name) + "', which has no meaning for a " +
                     std::string(nameOf(probe.shape)) + " probe; leave it out.");
  }
  return probe;
}

}  // namespace

std::span<const ProbeField> probeFields() {
  return kFields;
}

bool applies(const ProbeField& field, ProbeShape shape) {
  return field.use == Use::Always || (field.use == Use::Linear) == (shape == ProbeShape::Linear);
}

std::string_view nameOf(ProbeShape shape) {
  return kShapes[std::size_t(shape)];
}

std::vector<std::string> probePresetNames() {
  return presetNames(embeddedPresets(embedded::probes::files()));
}

Result<Probe> loadProbe(std::string_view nameOrPath) {
  return presetOrFile("a probe", nameOrPath, embeddedPresets(embedded::probes::files()), parseProbe);
}

Result<Probe> parseProbe(std::string_view text) {
  const auto json = parsedJson(text, "The probe");
  if (!json) return tl::unexpected(json.error());
  std::string trouble;
  Probe probe = probeFrom(*json, trouble);
  if (!trouble.empty()) return fail(std::move(trouble));
  if (auto ok = validate(probe); !ok) return tl::unexpected(ok.error());
  return probe;
}

std::string textOf(const Probe& probe) {
  nlohmann::ordered_json json{{"name", probe.name},
                              {"shape", nameOf(probe.shape)},
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
  const auto check = [&](double value, double low, double high, std::string_view name) {
    return checkRange(value, low, high, where + ": " + std::string(name));
  };
  if (probe.name.empty()) return fail("the probe has no name; give it one.");
  for (const Field& field : kFields) {
    if (!applies(field, probe.shape)) continue;
    if (auto ok = check(probe.*field.member, field.low, field.high, field.name); !ok) return ok;
  }
  if (probe.shape == ProbeShape::Curvilinear)
    if (auto ok = check(probe.faceRadius_mm, 5, 200, "faceRadius_mm"); !ok) return ok;
  if (auto ok =
          checkOrder(probe.minFrequency_MHz, probe.defaultFrequency_MHz, probe.maxFrequency_MHz, "frequency", where);
      !ok)
    return ok;
  return checkOrder(probe.minDepth_mm, probe.defaultDepth_mm, probe.maxDepth_mm, "depth", where);
}

}  // namespace insonate
