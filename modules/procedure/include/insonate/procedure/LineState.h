#pragma once

#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptSample.h>

#include <array>
#include <cstdint>
#include <string>

namespace insonate {

/// Rhythm of the heart. A guidewire that touches the wall of the heart causes extra beats.
enum class HeartRhythm { Sinus, ExtraBeats, Tachycardia };
/// Length of wire beyond the cavo-atrial junction from which on the rhythm is a tachycardia: the wire is then through
/// the right atrium.
inline constexpr double kTachycardiaFrom_mm = 40;
/// Distance by which a wire that met a resistance is withdrawn before it is advanced again; our choice.
inline constexpr double kBackOff_mm = 10;

/// State of the instruments of the line after the events and samples so far. The state decides which acts are possible;
/// rules and metrics decide which acts are right.
struct LineState {
  bool isNeedleInBody = false;
  bool isSyringeOn = true;      ///< a syringe closes the needle's hub
  bool isHubCovered = false;    ///< a finger closes the needle's hub
  bool isWireHeld = false;      ///< the hand holds the wire outside the body
  bool isWireLost = false;      ///< the whole wire is in the body
  bool isWireKinked = false;    ///< the wire in the body has a kink
  bool isNicked = false;        ///< the hole in the skin was enlarged for this wire
  bool isWireInNeedle = false;  ///< the wire runs through the needle that is in the body
  /// Lengths of the instruments below the skin; 0: outside.
  double wire_mm = 0, dilator_mm = 0, catheter_mm = 0;
  /// Length of the wire below the skin at which it met a resistance. 0: there is no resistance. The value becomes 0
  /// when the wire has gone on, or was withdrawn by kBackOff_mm.
  double wireStop_mm = 0;
  /// Structure in which the tip of the wire or the catheter last arrived (kVein, kArtery or another tissue), and its
  /// vessel (AttemptEvent::vessel); kBackground while the instrument is outside.
  Label wireIn = kBackground, catheterIn = kBackground;
  std::uint8_t wireVessel = 0, catheterVessel = 0;
  /// The live image has shown this wire in the target vein, in short axis and in long axis.
  bool isWireSeenInShortAxis = false, isWireSeenInLongAxis = false;
  HeartRhythm rhythm = HeartRhythm::Sinus;
  int dilations = 0;  ///< insertions of the dilator into a vessel, over this wire
  std::array<bool, kCatheterLumens> isAspirated{}, isFlushed{};
  std::array<int, kLineActs> performed{};  ///< number of times that each act was performed

  int count(LineAct act) const { return performed[static_cast<std::size_t>(act)]; }
  bool isWireIn() const { return wire_mm > 0; }
  /// Returns the length of wire, dilator or catheter below the skin; 0 for the needle.
  double length_mm(Instrument instrument) const;
  /// Tells whether air can reach the vessel through the needle's hub.
  bool isHubOpen() const { return isNeedleInBody && !isSyringeOn && !isHubCovered && !isWireInNeedle; }
};

/// Updates the state by the next sample or event of an attempt. `hasTarget`: see AttemptMetrics.
void follow(LineState& state, const AttemptSample& sample);
void follow(LineState& state, const AttemptEvent& event, bool hasTarget);

/// Returns the reason why an act is not possible now, as a sentence for the trainee; empty if the act is possible.
/// `lumen`: number of the catheter's lumen, for AspirateLumen and FlushLumen.
std::string refusalOf(const LineState& state, LineAct act, int lumen = 1);
/// Returns the reason why an instrument cannot be moved into the body (`isAdvanced`) or out of it; empty if it can.
std::string refusalOf(const LineState& state, Instrument instrument, bool isAdvanced);

}  // namespace insonate
