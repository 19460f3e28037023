#include "FormerProbe.h"

#include <insonate/core/JsonEntry.h>

#include <algorithm>
#include <array>

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

}  // namespace

nlohmann::json withFormerNames(const nlohmann::json& file, const std::string& where, std::string& trouble) {
  const auto has = [&](const char* name) { return file.contains(name); };
  if (!file.is_object() || std::ranges::none_of(kFormerNames, has)) return file;
  JsonEntry entry(file, where, keysOf(file), trouble);
  for (const char* name : kArrayNames)
    if (has(name))
      entry.refuse(std::string("has '") + name + "', which describes the array and does not go with widths such as '" +
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

}  // namespace insonate
