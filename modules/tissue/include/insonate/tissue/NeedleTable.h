#pragma once

#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Behavior of a structure's surface under a needle's tip: the needle's row of the thesis's Table II.
enum class NeedleWall {
  None,      ///< nothing: tissue goes over into tissue
  Membrane,  ///< gives way like a spring, then is punctured
  Hard,      ///< stops the needle
};

/// Resistance of a structure to an 18 G needle (1.27 mm).
struct NeedleTissue {
  NeedleWall wall = NeedleWall::None;
  double stiffness_Npmm = 0;         ///< k1 of a wall's force k1 d + k2 d^2, d the way that it is pushed before it
  double stiffening_Npmm2 = 0;       ///< k2; hard walls have none
  double puncture_N = 0;             ///< at which a membrane is punctured
  double cutting_N = 0;              ///< at the tip, while it makes new way
  double cuttingStiffness_Npmm = 0;  ///< of the tissue before the tip, until it is cut
  double friction_Npmm = 0;          ///< sliding, for each mm of shaft
  double stiction_Npmm = 0;          ///< before it slides, for each mm of shaft; at least friction_Npmm
  double viscosity_Nspmm2 = 0;       ///< N for each mm of shaft and mm/s of speed
  double lateral_Npmm2 = 0;          ///< stiffness against moving sideways, N/mm for each mm of depth
  bool probeTouches = false;         ///< the transducer's row of Table II
  bool operator==(const NeedleTissue&) const = default;
};

/// Needle properties by label. Labels that the table does not know read as soft tissue.
struct NeedleTable {
  std::string name;
  std::array<NeedleTissue, kLabelCount> tissues;

  const NeedleTissue& of(std::uint8_t label) const {
    return tissues[label < kLabelCount ? int{label} : int{kSoftTissue}];
  }
};

/// `measured` (the default), first, and `thesis` (walls exactly as in its Table II).
std::vector<std::string> needlePresetNames();

/// A preset's name or a JSON file of the same form, as for loadAcousticTable(). Fails with a sentence that names
/// tissue, field, value and allowed range; see resources/haptics/README.md for the form and the ranges.
Result<NeedleTable> loadNeedleTable(std::string_view nameOrPath);
Result<NeedleTable> parseNeedleTable(std::string_view json);

}  // namespace insonate
