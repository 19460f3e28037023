#pragma once

#include "line/SalineBubbles.h"

#include <insonate/cases/VesselName.h>
#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/deformation/Physiology.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptSample.h>
#include <insonate/procedure/LineState.h>
#include <insonate/simulator/SalineFlush.h>
#include <insonate/simulator/VesselLocator.h>
#include <insonate/ultrasound/Instruments.h>
#include <insonate/wire/VesselTree.h>
#include <insonate/wire/WireSolver.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// The needle at one moment, as the hands of the line see it.
struct LineNeedle {
  bool isInBody = false;
  Label in = kBackground;  ///< structure in which the tip is: NeedleState::in
  double depth_mm = 0;     ///< depth of the tip below the puncture of the skin, along the needle
  Transform patientFromNeedle;
  Transform restFromPatient;  ///< affine map to the undeformed tissue near the tip
  double length_mm = 70;      ///< length from the tip to the hub
};

/// Moves wire, dilator and catheter as the hands request, computes where they go in the vessels of a case, and reports
/// the events. The wire enters through the needle and stays in static equilibrium (WireSolver); dilator and catheter
/// follow the straight path of the needle and then the wire. One object must not be used concurrently.
class LineHands {
 public:
  /// Fails if the case names no vessels, since the wire needs their center lines. Vessels are round: a vein that is
  /// flat in the CT of a supine patient is full with the head down, and a wire meets no resistance at its flat walls.
  static Result<LineHands> make(std::span<const NamedVessel> vessels, VesselLocator locator);
  /// Sets the center lines of all veins, by which a vein without a name is recognized; null: unknown.
  void setVeins(std::shared_ptr<const std::vector<CenterLine>> veins) { veins_ = std::move(veins); }

  /// Sets needle and blood pressure of this moment; call it at least 30 times per second, with increasing times.
  void follow(std::int64_t time_us, const LineNeedle& needle, const Physiology& physiology, double bloodTime_s);
  /// Adds an event that the hands did not cause: a puncture by the needle, a new needle.
  void add(const AttemptEvent& event);

  /// Performs an act at a time not before that of follow(). Returns AttemptEvent::amount of the act, e.g. the pressure.
  /// Fails with a sentence for the trainee if the act is not possible.
  Result<double> perform(std::int64_t time_us, LineAct act, int lumen = 1);
  /// Moves an instrument into the body, or out of it if `by_mm` is negative. Returns the reason if the instrument does
  /// not move, or not by the whole distance; else an empty text.
  std::string move(std::int64_t time_us, Instrument instrument, double by_mm);
  /// Reports which views of the wire the live image has shown for half a second, and a flush whose bubbles it has
  /// shown. `sight`: empty without a live image.
  struct Sight {
    bool isInShortAxis = false, isInLongAxis = false;
    Vec3 at_mm{};     ///< place of the wire in the image, undeformed tissue, patient space
    int bubbles = 0;  ///< number of bubbles that the image shows
    /// Width of the pleura of side() in the image, and the part of it under which the lung does not slide.
    double pleura_mm = 0, still_mm = 0;
  };
  void look(const std::optional<Sight>& sight);

  /// Writes the lengths of the instruments into a sample.
  void fill(AttemptSample& sample) const;
  /// Returns the events since the last call, in the order of their times.
  std::vector<AttemptEvent> takeEvents();

  const LineState& state() const { return state_; }
  /// Returns the force of the wire on the hand that inserts it, against the insertion; 0 without a wire.
  double wireResistance_N() const { return hasWire_ ? solver_.state().resistance_N : 0; }
  /// Returns the course of the wire in undeformed tissue, patient space, from the puncture of the skin to its tip;
  /// empty without a wire.
  std::span<const Vec3> wire_mm() const { return wirePath_; }
  /// Returns the instruments in the body as the image shows them, undeformed tissue, patient space, to 0.01 mm. The
  /// part of the wire in the needle is left out.
  std::vector<FlexibleRod> rods() const;
  /// Returns rods() if they have changed since the last call that returned them; at most ten times per second, since
  /// each state is recorded. Else empty.
  std::optional<std::vector<FlexibleRod>> takeRods();
  /// Returns the side of the body on which the target lies; empty: its name states none.
  std::optional<BodySide> side() const { return side_; }
  /// Returns the last flush for bubbles; empty: none.
  const std::optional<SalineFlush>& flush() const { return flush_; }
  /// Returns the bubbles of this moment, undeformed tissue, patient space; valid until the next call.
  std::span<const Bubble> bubbles();
  /// Returns the unit direction of the vessel at a place of the wire, undeformed tissue, patient space.
  Vec3 vesselAxisAt(Vec3 rest_mm) const;

 private:
  LineHands(VesselTree tree, SalineBubbles bubbles, Wire wire, Wire dilator, Wire catheter, VesselLocator locator);

  std::string moveWire(double by_mm);
  std::string moveOverWire(Instrument instrument, double by_mm);
  std::string enterOverWire(Instrument instrument, double& in_mm, double by_mm);
  std::string wireRefusal(double by_mm, double left_mm) const;
  void strainWire(double by_mm, double moved_mm);
  void startWire();
  void feedWire(double by_mm);
  void dragWire(double by_mm);
  void reportWire(WireTip before);
  void removeWire();
  void breatheAir(double seconds);
  void flushSaline(const AttemptEvent& event, Vec3 from_mm);
  void lookForBubbles(int seen);
  void lookAtLung(const Sight& sight);
  std::string lungRefusal() const;
  void dragByNeedle(const LineNeedle& before);
  void syncState();
  void reportStop(Instrument instrument, Vec3 tip_mm, double depth_mm);
  void report(AttemptEvent event);
  void updatePath();
  double wireBelowSkin_mm() const;
  double freeWire_mm(Instrument over, double in_mm) const;
  Vec3 pointAt(Instrument instrument, double below_mm) const;
  std::uint8_t vesselAt(Label label, Vec3 rest_mm) const;

  VesselTree tree_;
  WireSolver solver_;
  Wire dilator_, catheter_;
  VesselLocator locator_;
  std::shared_ptr<const std::vector<CenterLine>> veins_;
  LineState state_;
  std::vector<AttemptEvent> events_;
  std::int64_t time_us_ = 0, followed_us_ = 0;
  LineNeedle needle_;
  Physiology physiology_;
  double bloodTime_s_ = 0;  ///< time in the cycles of heartbeat and breathing
  struct Entry {
    Label wall;
    double depth_mm;
  };
  std::vector<Entry> entries_;  ///< walls of vessels through which the needle went, in their order
  /// Path of the needle when the wire began: puncture of the skin and tip of the needle, undeformed tissue.
  Vec3 skin_mm_{}, entry_mm_{};
  double tract_mm_ = 0, vesselAt_mm_ = 0;  ///< depths of the needle's tip and of the wall of the vessel on this path
  bool hasWire_ = false;
  std::array<bool, kInstruments> isStopTold_{};  ///< the present stop of each instrument is already reported
  std::vector<Vec3> wirePath_, dilatorPath_, catheterPath_;
  double dilator_mm_ = 0, catheter_mm_ = 0;
  bool isDilatorIn_ = false, isCatheterIn_ = false, isInHeart_ = false, isThroughAtrium_ = false;
  double forced_mm_ = 0;     ///< distance by which the wire was pushed on against its present stop
  double draggedAt_mm_ = 0;  ///< depth of the needle's tip to which the needle has taken a loose wire
  double air_ml_ = 0;
  bool haveRodsMoved_ = false;
  std::int64_t rodsTaken_us_ = 0;
  bool isBreathing_ = false, hasImage_ = false;
  std::optional<std::int64_t> shortSince_us_, longSince_us_, bubblesSince_us_;
  SalineBubbles bubbles_;
  std::optional<SalineFlush> flush_;
  AttemptEvent flushed_;         ///< the act that flush_ belongs to
  double flushBloodTime_s_ = 0;  ///< bloodTime_s_ at the flush
  std::optional<BodySide> side_;
  std::optional<std::int64_t> lungSince_us_;  ///< the image shows the pleura since
  bool isLungSeen_ = false;                   ///< for long enough, since this catheter is in a vessel
  bool isLungStill_ = false;                  ///< when it was seen last, most of it did not slide
};

}  // namespace insonate
