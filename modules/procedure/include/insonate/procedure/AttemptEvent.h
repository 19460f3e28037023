#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/procedure/LineInstruments.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace insonate {

/// Kind of an event of an attempt. The numbers are stored in recordings and must not change.
enum class AttemptEventKind : std::uint8_t {
  Entered = 0,         ///< the needle's tip punctured a wall (surface of a structure, AttemptEvent::wall) from outside
  Left = 1,            ///< the tip punctured the wall from inside while advancing, as at the posterior wall of a vessel
  Withdrawn = 2,       ///< the tip was withdrawn through the hole of an earlier puncture (Entered or Left)
  Struck = 3,          ///< the tip met bone
  NeedleReplaced = 4,  ///< the trainee took a new needle
  Frozen = 5,          ///< the image was frozen and the needle fixed in place, by pedal or key
  Released = 6,        ///< image and needle were released after Frozen
  Positioned = 7,      ///< the tilt of the patient's table was changed to AttemptEvent::tilt_deg
  Centered = 8,        ///< the target vein has been in the middle of the live image for a second
  Compressed = 9,      ///< the probe has compressed the target vein, or another named vein, in the middle of the live
                       ///< image
  Performed = 10,      ///< the trainee performed AttemptEvent::act
  /// The live image has shown the wire in a vessel: crossing the image plane (short axis), or along the plane (long
  /// axis).
  WireInShortAxis = 11,
  WireInLongAxis = 12,
  InstrumentEntered = 13,  ///< the tip of AttemptEvent::instrument came into a vessel, or into tissue (into)
  InstrumentRemoved = 14,  ///< the instrument was withdrawn out of the skin
  InstrumentStopped = 15,  ///< the instrument met a resistance that it cannot pass
  WireLost = 16,           ///< the whole wire is in the body
  AirEntered = 17,         ///< air was sucked into the vein through an open hub (AttemptEvent::amount, ml)
  Ectopy = 18,             ///< the wire in the heart causes extra beats
  ColorShown = 19,         ///< color Doppler of the live image has covered the target vein for a second
  WireKinked = 20,         ///< the wire got a kink, and nothing can follow over it any more
  Tachycardia = 21,        ///< the wire was pushed on beyond the right atrium and causes a run of tachycardia
  BubblesSeen = 22,        ///< the live image has shown the bubbles of a saline flush (AttemptEvent::wall, vessel)
  Pneumothorax = 23,       ///< the needle has punctured the pleura, and the lung of this side is detached from now on
};
inline constexpr int kAttemptEventKinds = 24;

/// Returns the name of a kind of event in procedures: "wire in short axis".
std::string_view nameOf(AttemptEventKind kind);
/// Returns the names of all kinds of events, in their order.
const std::array<std::string_view, kAttemptEventKinds>& attemptEventNames();

/// Value of AttemptEvent::vessel for a vessel that the case does not name.
inline constexpr std::uint8_t kUnnamedVessel = 255;

/// One event of an attempt: its kind, time and place. Positions and directions are in patient space.
struct AttemptEvent {
  std::int64_t time_us = 0;  ///< time since the recording began
  AttemptEventKind kind = AttemptEventKind::Entered;
  Label wall = kSkin;  ///< structure whose surface was met or punctured; used by Entered, Left, Withdrawn, Struck,
                       ///< Centered, Compressed, ColorShown, WireInShortAxis, WireInLongAxis, BubblesSeen and
                       ///< InstrumentEntered
  Label into = kBackground;  ///< tissue or structure in which the tip is after the event
  /// Number of the vessel to which `wall` belongs, counted from 1 in AttemptHeader::vessels; 1 is the target vein. 0:
  /// unknown; kUnnamedVessel: a vessel without a name.
  std::uint8_t vessel = 0;
  /// Tip of the needle, and unit direction of insertion, patient space. For Centered, Compressed and ColorShown:
  /// center of the vein, and the probe's axis. For other instruments: the tip of the instrument, and its direction.
  Vec3 tip_mm{}, axis{0, 0, 1};
  /// Depth of the puncture below the puncture of the skin, along the needle; for other instruments the length below the
  /// skin.
  double depth_mm = 0;
  std::optional<Vec3> outward{};  ///< unit normal of the undeformed skin at the puncture of the skin; empty: unknown
  double tilt_deg = 0;  ///< tilt of the patient's table in a Positioned event; positive: head down (Trendelenburg)
  LineAct act = LineAct::CheckConsent;  ///< the act of a Performed event
  Instrument instrument =
      Instrument::Needle;  ///< the instrument of an event from InstrumentEntered to WireLost, and of WireKinked
  double amount = 0;       ///< quantity of a Performed event (see LineAct) or of AirEntered (ml); else 0

  bool operator==(const AttemptEvent&) const = default;
};

}  // namespace insonate
