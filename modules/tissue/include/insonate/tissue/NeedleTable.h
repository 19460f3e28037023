#pragma once

#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Resistance of a structure's surface to the needle's tip, as in the needle's row of Table II of the thesis (see
/// Labels.h).
enum class NeedleWall {
  None,      ///< no wall: the surface does not resist the needle
  Membrane,  ///< wall that resists like a spring until it is punctured
  Hard,      ///< wall that stops the needle
};

/// Resistance of a structure to an 18 G needle (outer diameter 1.27 mm).
struct NeedleTissue {
  NeedleWall wall = NeedleWall::None;
  double stiffness_Npmm = 0;    ///< k1 in the wall's force k1 d + k2 d^2 against the tip; d is the indentation in mm
  double stiffening_Npmm2 = 0;  ///< k2 in the wall's force k1 d + k2 d^2 against the tip; 0 for hard walls
  double puncture_N = 0;        ///< force at which a membrane is punctured
  double cutting_N = 0;         ///< force at the tip while the needle cuts forward
  double cuttingStiffness_Npmm = 0;  ///< stiffness of the tissue ahead of the tip until the tissue is cut
  double friction_Npmm = 0;          ///< friction on the sliding shaft, per mm of shaft in the structure
  /// Static friction of the resting shaft, per mm of shaft in the structure; at least friction_Npmm.
  double stiction_Npmm = 0;
  double viscosity_Nspmm2 = 0;  ///< viscous force on the shaft in N, per mm of shaft and per mm/s of speed
  /// Stiffness in N/mm against sideways motion of the shaft, per mm of shaft in the structure.
  double lateral_Npmm2 = 0;
  /// True: the structure resists the probe (the transducer's row of Table II of the thesis).
  bool probeTouches = false;
  bool operator==(const NeedleTissue&) const = default;
};

/// Needle properties by label. Labels that are not in the table have the properties of soft tissue.
struct NeedleTable {
  std::string name;
  std::array<NeedleTissue, kLabelCount> tissues;

  /// Returns the resistance of the tissue with this label.
  const NeedleTissue& of(std::uint8_t label) const {
    return tissues[label < kLabelCount ? int{label} : int{kSoftTissue}];
  }
};

/// Returns the names of the presets: `measured` (the default) and `thesis` (walls exactly as in Table II of the
/// thesis).
std::vector<std::string> needlePresetNames();

/// Loads a preset by name, or a JSON file of the same form by path. A file may name a preset as its "base" and replace
/// single values of it. Fails with a sentence that names tissue, field, value and allowed range.
/// resources/haptics/README.md describes the form and the ranges.
Result<NeedleTable> loadNeedleTable(std::string_view nameOrPath);
Result<NeedleTable> parseNeedleTable(std::string_view json);

}  // namespace insonate
