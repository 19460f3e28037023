#pragma once

#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Behavior of a structure under compression.
enum class Mechanics {
  Solid,  ///< elastic tissue
  Rigid,  ///< does not move (bone)
  /// vessel: blood under pressure, which can flow out of the image plane; the vessel wall lies outside the label
  Lumen,
  Gas,  ///< offers no resistance (airway, lung, outside the patient)
};

struct MechanicalTissue {
  Mechanics kind = Mechanics::Solid;
  double young_kPa = 10;       ///< Young's modulus of solids, above 0; infinity for rigid structures
  double poisson = 0.49;       ///< Poisson's ratio, 0 to 0.499
  double wall_mm = 0;          ///< lumens: thickness of the vessel wall, which lies outside the label
  double wallYoung_kPa = 0;    ///< lumens: Young's modulus of the vessel wall
  double sheath_mm = 0;        ///< lumens: thickness of the loose tissue around the vessel wall
  double sheathYoung_kPa = 0;  ///< lumens: Young's modulus of the loose tissue around the vessel wall
  double pressure_kPa = 0;     ///< lumens: blood pressure above atmospheric when the CT was taken
  bool operator==(const MechanicalTissue&) const = default;
};

/// Mechanical properties by label. Labels that are not in the table have the properties of soft tissue.
struct MechanicalTable {
  std::string name;
  std::array<MechanicalTissue, kLabelCount> tissues;

  /// Returns the properties of the tissue with this label.
  const MechanicalTissue& of(std::uint8_t label) const {
    return tissues[label < kLabelCount ? int{label} : int{kSoftTissue}];
  }
};

/// Returns the names of the presets: `measured` (the default) and `thesis` (Table I of the thesis; see Labels.h).
std::vector<std::string> mechanicalPresetNames();

/// Loads a preset by name, or a JSON file of the same form by path. A file may name a preset as its "base" and replace
/// single values of it. Fails with a sentence that names tissue, field, value and allowed range.
/// resources/mechanics/README.md describes the form and the ranges.
Result<MechanicalTable> loadMechanicalTable(std::string_view nameOrPath);
Result<MechanicalTable> parseMechanicalTable(std::string_view json);

}  // namespace insonate
