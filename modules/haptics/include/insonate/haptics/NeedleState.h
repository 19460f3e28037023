#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>

namespace insonate {

enum class NeedleEventKind : std::uint8_t {
  Entered,    ///< punctured the surface of `wall` from outside
  Left,       ///< punctured it from inside: the back wall of a vessel
  Withdrawn,  ///< pulled back through the hole of either
  Struck,     ///< met bone
};

/// An event of the needle; each puncture of each wall is reported once.
struct NeedleEvent {
  std::int64_t time_ns = 0;
  NeedleEventKind kind = NeedleEventKind::Entered;
  Label wall = kSkin;        ///< one of kNeedleWalls
  Label into = kBackground;  ///< what the tip is in afterwards
  Vec3 tip_mm, axis;         ///< tip and direction of the needle, patient space
  double depth_mm = 0;       ///< of the hole below the skin's, along the needle
};

struct NeedleState {
  bool inBody = false;
  Label in = kBackground;  ///< what the tip is in: tissue counts as entered once its wall is punctured
  double depth_mm = 0;     ///< of the tip below the entry, along the needle's track
  Vec3 entry_mm,
      track{0, 0, 1};    ///< where the skin was punctured, and the direction of the track; at rest, patient space
  bool tenting = false;  ///< a wall gives way before the tip
  Label tented = kSkin;  ///< which
  double tent_mm = 0;    ///< how far
  bool onBone = false;
  double axial_N = 0;  ///< resistance along the needle
};

}  // namespace insonate
