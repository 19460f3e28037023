#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <optional>

namespace insonate {

/// Numbers are those of recordings: they stay.
enum class AttemptEventKind : std::uint8_t {
  Entered = 0,         ///< the tip punctured `wall` from outside
  Left = 1,            ///< from inside, going on: the back wall of a vessel
  Withdrawn = 2,       ///< pulled back through the hole of either
  Struck = 3,          ///< met bone
  NeedleReplaced = 4,  ///< a new needle was taken from the tray
  Frozen = 5,          ///< the pedal holds the needle where it is
  Released = 6,        ///< and lets it go
  Positioned = 7,      ///< the patient lies otherwise: `tilt_deg`
  Centered = 8,        ///< the target vein lies in the middle of the live image, and has for a second
  Compressed = 9,      ///< and the probe has flattened it there
};
inline constexpr int kAttemptEventKinds = 10;

/// AttemptEvent::vessel of a vessel that the case does not name.
inline constexpr std::uint8_t kUnnamedVessel = 255;

/// One event of an attempt: kind, time and place. Patient space.
struct AttemptEvent {
  std::int64_t time_us = 0;  ///< since the recording began
  AttemptEventKind kind = AttemptEventKind::Entered;
  Label wall = kSkin;        ///< of the first four kinds and the last two
  Label into = kBackground;  ///< what the tip is in afterwards
  /// Vessel to which this wall belongs: 1 is the first of AttemptHeader::vessels, the target; 0 if unknown.
  std::uint8_t vessel = 0;
  /// Tip of the needle, and the unit direction in which it goes in. Of the last two kinds: the middle of the vein, and
  /// the probe's axis.
  Vec3 tip_mm{}, axis{0, 0, 1};
  double depth_mm = 0;  ///< of the hole below the skin's, along the needle: d1 of the thesis where it is the vein's
  std::optional<Vec3> outward{};  ///< unit normal of the skin at its hole, without the probe; none: not known
  double tilt_deg = 0;            ///< head down is positive (Trendelenburg)

  bool operator==(const AttemptEvent&) const = default;
};

}  // namespace insonate
