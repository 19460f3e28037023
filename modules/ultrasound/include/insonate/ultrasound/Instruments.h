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

/// A bubble of gas in blood, as in agitated saline: it scatters equally in all directions, and moves with the tissue
/// around it.
struct Bubble {
  Vec3 position_mm;       ///< patient LPS of the tissue at rest
  double amplitude = 10;  ///< peak of its echo's envelope in the middle of the slice, relative to speckle of 0 dB
};

/// The instruments that a frame shows. The caller keeps them alive during the frame.
struct Instruments {
  const Needle* needle = nullptr;       ///< null: no needle
  std::span<const FlexibleRod> rods{};  ///< guidewires and catheters
  std::span<const Bubble> bubbles{};    ///< bubbles of saline that was flushed through an instrument

  Instruments() = default;
  Instruments(const Needle* shown, std::span<const FlexibleRod> shownRods = {},
              std::span<const Bubble> shownBubbles = {})
      : needle(shown), rods(shownRods), bubbles(shownBubbles) {}
};

}  // namespace insonate
