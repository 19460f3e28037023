#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/Needle.h>

#include <span>
#include <vector>

namespace insonate {

enum class RodMaterial {
  SteelCoil,  ///< guidewire: bright at all angles, with a comet tail and a shadow
  Polymer     ///< catheter or dilator: echoes from the near and the far wall, anechoic lumen
};

/// A flexible rod, such as a guidewire or a catheter, that moves with the tissue around it. Patient LPS of the tissue
/// at rest, millimeters.
struct FlexibleRod {
  RodMaterial material = RodMaterial::SteelCoil;
  double radius_mm = 0.405;    ///< outer radius; 0.1 to 3
  double innerRadius_mm = 0;   ///< radius of the lumen of a catheter; 0 to 95 % of `radius_mm`
  std::vector<Vec3> nodes_mm;  ///< center line, 2 to 4000 nodes
};

/// Fails with a sentence on values that are not finite or out of range.
Result<void> validate(const FlexibleRod& rod);

/// The instruments that a frame shows. The caller keeps them alive during the frame.
struct Instruments {
  const Needle* needle = nullptr;       ///< null: no needle
  std::span<const FlexibleRod> rods{};  ///< guidewires and catheters

  Instruments() = default;
  Instruments(const Needle* shown, std::span<const FlexibleRod> shownRods = {}) : needle(shown), rods(shownRods) {}
};

}  // namespace insonate
