#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <optional>

namespace insonate {

/// Kind of an event. The numbers are stored in recordings and must not change.
enum class AttemptEventKind : std::uint8_t {
  Entered = 0,         ///< the tip punctured `wall` from outside
  Left = 1,            ///< the tip punctured the wall from inside while advancing: the posterior wall of a vessel
  Withdrawn = 2,       ///< the tip was pulled back through the hole of an earlier puncture, entered or left
  Struck = 3,          ///< the tip met bone
  NeedleReplaced = 4,  ///< a new needle was taken from the tray
  Frozen = 5,          ///< the pedal holds the needle in place
  Released = 6,        ///< the pedal releases the needle
  Positioned = 7,      ///< the patient's position has changed to `tilt_deg`
  Centered = 8,        ///< the target vein has been in the middle of the live image for a second
  Compressed = 9,      ///< the probe has flattened the target vein in the middle of the live image
};
inline constexpr int kAttemptEventKinds = 10;

/// AttemptEvent::vessel of a vessel that the case does not name.
inline constexpr std::uint8_t kUnnamedVessel = 255;

/// One event of an attempt: kind, time and place. Patient space.
struct AttemptEvent {
  std::int64_t time_us = 0;  ///< since the recording began
  AttemptEventKind kind = AttemptEventKind::Entered;
  Label wall = kSkin;        ///< for the first four kinds and the last two
  Label into = kBackground;  ///< tissue or structure in which the tip is after the event
  /// Vessel to which this wall belongs: 1 is the first of AttemptHeader::vessels, the target; 0 if unknown.
  std::uint8_t vessel = 0;
  /// Tip of the needle, and the unit direction of insertion. For the last two kinds: the center of the vein, and the
  /// probe's axis.
  Vec3 tip_mm{}, axis{0, 0, 1};
  /// Depth of the hole below the hole in the skin, along the needle; for the vein: d1 of the thesis.
  double depth_mm = 0;
  std::optional<Vec3> outward{};  ///< unit normal of the undeformed skin at its hole; empty: unknown
  double tilt_deg = 0;            ///< positive: head down (Trendelenburg)

  bool operator==(const AttemptEvent&) const = default;
};

}  // namespace insonate
