#pragma once

#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Behavior of a structure's surface at the needle's tip: the needle's row of the thesis's Table II.
enum class NeedleWall {
  None,      ///< no wall: the surface does not resist the needle
  Membrane,  ///< yields like a spring, then is punctured
  Hard,      ///< stops the needle
};

/// Resistance of a structure to an 18 G needle (1.27 mm).
struct NeedleTissue {
  NeedleWall wall = NeedleWall::None;
  double stiffness_Npmm = 0;         ///< k1 of a wall's force k1 d + k2 d^2, where d is the wall's indentation
  double stiffening_Npmm2 = 0;       ///< k2 of that force; 0 for hard walls
  double puncture_N = 0;             ///< force at which a membrane is punctured
  double cutting_N = 0;              ///< force at the tip while the needle cuts forward
  double cuttingStiffness_Npmm = 0;  ///< stiffness of the tissue ahead of the tip until the tissue is cut
  double friction_Npmm = 0;          ///< friction while the shaft slides, per mm of shaft
  double stiction_Npmm = 0;          ///< friction up to which the shaft sticks, per mm of shaft; at least friction_Npmm
  double viscosity_Nspmm2 = 0;       ///< viscous force in N per mm of shaft and per mm/s of speed
  double lateral_Npmm2 = 0;          ///< stiffness against lateral motion, N/mm per mm of depth
  bool probeTouches = false;         ///< false: the probe passes through it; the transducer's row of Table II
  bool operator==(const NeedleTissue&) const = default;
};

/// Needle properties by label. Labels outside the table have the properties of soft tissue.
struct NeedleTable {
  std::string name;
  std::array<NeedleTissue, kLabelCount> tissues;

  const NeedleTissue& of(std::uint8_t label) const {
    return tissues[label < kLabelCount ? int{label} : int{kSoftTissue}];
  }
};

/// Returns the presets' names: `measured` (the default) and `thesis` (walls exactly as in its Table II).
std::vector<std::string> needlePresetNames();

/// Loads a preset by name, or a JSON file of the same form, like loadAcousticTable(). Fails with a sentence that names
/// tissue, field, value and allowed range; resources/haptics/README.md describes the form and the ranges.
Result<NeedleTable> loadNeedleTable(std::string_view nameOrPath);
Result<NeedleTable> parseNeedleTable(std::string_view json);

}  // namespace insonate
