#include "FormerProbe.h"

#include "JsonFields.h"

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

Result<nlohmann::json> withFormerNames(const nlohmann::json& file, const std::string& where) {
  const auto has = [&](const char* name) { return file.contains(name); };
  if (!file.is_object() || std::ranges::none_of(kFormerNames, has)) return file;
  for (const char* name : kArrayNames)
    if (has(name))
      return fail(where + ": " + name + " describes the array and does not go with widths such as " +
                  *std::ranges::find_if(kFormerNames, has) + "; leave out the widths.");
  double pulse = 0, width = 0, slice = 0, lens_mm = 0;
  for (const auto& [name, value] : {std::pair{"axialFwhm_wavelengths", &pulse},
                                    {"lateralFNumber", &width},
                                    {"elevationFwhm_wavelengths", &slice},
                                    {"elevationFocus_mm", &lens_mm}}) {
    if (!has(name)) return fail(where + ": '" + name + "' is missing.");
    const auto number = fields::readNumber(file[name], name, where);
    if (!number) return tl::unexpected(number.error());
    if (auto ok = fields::checkRange(*number, 0.5, 400, name, where); !ok) return tl::unexpected(ok.error());
    *value = *number;
  }
  nlohmann::json array = file;
  for (const char* name : kFormerNames) array.erase(name);
  array["pitch_mm"] = pitchOf_mm(file.value("shape", nlohmann::json()));
  array["bandwidth"] = std::clamp(0.441 / pulse, 0.1, 1.5);
  array["receiveFNumber"] = std::clamp(width / 1.733, 0.5, 10.0);
  array["transmitFNumber"] = 2 * array["receiveFNumber"].get<double>();
  array["apodization"] = "hann";
  array["elementHeight_mm"] = std::clamp(0.98 * lens_mm / slice, 1.0, 40.0);
  return array;
}

}  // namespace insonate
