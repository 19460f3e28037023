#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>

namespace insonate {

enum class NeedleEventKind : std::uint8_t {
  Entered,    ///< punctured `wall` from outside
  Left,       ///< punctured `wall` from inside: the posterior wall of a vessel
  Withdrawn,  ///< pulled back through the hole of an earlier puncture, entered or left
  Struck,     ///< met bone
};

/// An event of the needle; each puncture of each wall is reported once.
struct NeedleEvent {
  std::int64_t time_ns = 0;
  NeedleEventKind kind = NeedleEventKind::Entered;
  Label wall = kSkin;        ///< one of kNeedleWalls
  Label into = kBackground;  ///< tissue or structure in which the tip is after the event
  Vec3 tip_mm, axis;         ///< tip and direction of the needle, patient space
  double depth_mm = 0;       ///< depth of the hole below the hole in the skin, along the needle
};

struct NeedleState {
  bool inBody = false;
  Label in = kBackground;  ///< tissue at the tip; tissue counts as entered once its wall is punctured
  double depth_mm = 0;     ///< depth of the tip below the entry, along the needle's track
  /// Place of the skin's puncture, and direction of the track; at rest, patient space.
  Vec3 entry_mm, track{0, 0, 1};
  bool tenting = false;  ///< the tip indents a wall that it has not punctured
  Label tented = kSkin;  ///< the wall that is indented
  double tent_mm = 0;    ///< depth of the indentation
  bool onBone = false;
  double axial_N = 0;  ///< resistance along the needle
};

}  // namespace insonate
