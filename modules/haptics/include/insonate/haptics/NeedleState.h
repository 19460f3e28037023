#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>

namespace insonate {

/// Kind of contact of the needle's tip with a wall (surface of a structure, NeedleEvent::wall).
enum class NeedleEventKind : std::uint8_t {
  Entered,    ///< the tip punctured the wall from outside
  Left,       ///< the tip punctured the wall from inside, as at the posterior wall of a vessel
  Withdrawn,  ///< the tip was withdrawn through the hole of an earlier puncture (Entered or Left)
  Struck,     ///< the tip met bone
};

/// Minimum cosine of the angle between needle and normal of a wall (70 degrees) at which the tip punctures the wall for
/// certain. A tip that meets the wall flatter slides along it, or rolls off when it has left the structure on the other
/// side.
inline constexpr double kRollCosine = 0.35;

/// A contact event of the needle. Each puncture of each wall is reported once.
struct NeedleEvent {
  std::int64_t time_ns = 0;
  NeedleEventKind kind = NeedleEventKind::Entered;
  Label wall = kSkin;        ///< structure whose surface the tip met: one of kNeedleWalls
  Label into = kBackground;  ///< tissue or structure in which the tip is after the event
  Vec3 tip_mm, axis;         ///< tip and direction of the needle, patient space
  double depth_mm = 0;     ///< position of the wall, before the tip moved it, along the needle from the skin's puncture
  double inserted_mm = 0;  ///< depth of the tip at the event, as NeedleState::depth_mm: the wall bends before it gives
};

/// State of the needle in the tissue at one tick of the force loop.
struct NeedleState {
  bool inBody = false;
  Label in =
      kBackground;  ///< tissue at the tip; a structure counts as tissue at the tip only after its wall was punctured
  double depth_mm = 0;  ///< depth of the tip below the puncture of the skin, along the needle's track
  /// Puncture of the skin, and unit direction of the needle's track; in undeformed tissue, patient space.
  Vec3 entry_mm, track{0, 0, 1};
  bool tenting = false;  ///< true: the tip indents a wall that it has not punctured
  Label tented = kSkin;  ///< structure whose wall the tip indents
  double tent_mm = 0;    ///< depth of the indentation by the tip
  bool onBone = false;
  double axial_N = 0;  ///< axial resistance of the tissue to the needle
};

}  // namespace insonate
