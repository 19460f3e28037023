#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ProbeHand.h>

#include <functional>
#include <optional>

namespace insonate::train {

/// Directions in which a hand can move the probe.
enum class HandAxis { Lateral, Elevation, Rotation, Tilt, Rock, Press };

/// Position of the probe, in the numbers that a user reads and types.
struct HandNumbers {
  Vec3 skin_mm;             ///< patient LPS
  double rotation_deg = 0;  ///< 0: across the body, marker toward the patient's left; -180..180
  double tilt_deg = 0, rock_deg = 0, press_mm = 0;
  double of(HandAxis axis) const;  ///< of the four that are turned or pressed; 0 for the others
};

HandNumbers numbersOf(const ProbeHandState& state);

/// The probe in the user's hand. A gesture (a key held down, a drag, a turn of the wheel) is one move, to be undone as
/// a whole. Without a hand nothing moves. For one thread.
class ProbeControl {
 public:
  void setHand(std::optional<ProbeHand> hand);
  bool ready() const { return hand_.has_value(); }

  /// The moves that follow, up to the next begin(), are one gesture.
  void begin() { gestureOpen_ = false; }
  /// Sets a listener that is called once in a gesture, when it has moved the probe, with the probe's former state.
  void setGestureBegan(std::function<void(const ProbeHandState& before)> listener) {
    gestureBegan_ = std::move(listener);
  }
  HandMove move(HandAxis axis, double mmOrDegrees);
  HandMove slide(double lateral_mm, double elevation_mm);
  /// Moves to a typed number; slides have none.
  HandMove set(HandAxis axis, double mmOrDegrees);
  HandMove moveTo(Vec3 patient_mm);
  HandMove setPose(const StartPose& pose);
  HandMove setPose(const ProbeHandState& state);
  /// No gesture: a device holds the probe like this.
  void follow(const Transform& patientFromProbe);
  /// No gesture: puts the probe where it was.
  void restore(const ProbeHandState& state);

  const ProbeHand* hand() const { return hand_ ? &*hand_ : nullptr; }
  HandNumbers numbers() const { return hand_ ? numbersOf(hand_->state()) : HandNumbers{}; }

 private:
  template <class Move>
  HandMove done(const Move& move);

  std::optional<ProbeHand> hand_;
  std::function<void(const ProbeHandState&)> gestureBegan_;
  bool gestureOpen_ = false;
};

}  // namespace insonate::train
