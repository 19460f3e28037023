#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ProbePlacement.h>

#include <functional>
#include <optional>

namespace insonate::train {

/// Directions in which the user can move the probe.
enum class HandAxis { Lateral, Elevation, Rotation, Tilt, Rock, Press };

/// Position of the probe as numbers that the user reads and types.
struct HandNumbers {
  Vec3 skin_mm;  ///< position on the skin in the patient's frame (LPS)
  /// rotation, -180 to 180; 0: the image plane is transverse, with the marker toward the patient's left
  double rotation_deg = 0;
  double tilt_deg = 0, rock_deg = 0, press_mm = 0;
  double of(HandAxis axis) const;  ///< value for Rotation, Tilt, Rock or Press; 0 for the other axes
};

HandNumbers numbersOf(const ProbePlacementState& state);

/// The probe that the user moves. A gesture (a key held down, a drag, a turn of the wheel) is undone as one move.
/// Without a ProbePlacement all moves have no effect. One object must be used on one thread only.
class ProbeControl {
 public:
  void setHand(std::optional<ProbePlacement> hand);
  bool ready() const { return hand_.has_value(); }

  /// Begins a gesture. All moves until the next begin() belong to the gesture.
  void begin() { gestureOpen_ = false; }
  /// Sets a listener that is called once per gesture, after its first move, with the probe's state before the gesture.
  void setGestureBegan(std::function<void(const ProbePlacementState& before)> listener) {
    gestureBegan_ = std::move(listener);
  }
  MoveResult move(HandAxis axis, double mmOrDegrees);
  MoveResult slide(double lateral_mm, double elevation_mm);
  /// Moves the probe to a typed number. Not for Lateral and Elevation, for which there is no number.
  MoveResult set(HandAxis axis, double mmOrDegrees);
  MoveResult moveTo(Vec3 patient_mm);
  MoveResult setPose(const StartPose& pose);
  MoveResult setPose(const ProbePlacementState& state);
  /// Sets the pose that a device gives the probe; this is no gesture.
  void follow(const Transform& patientFromProbe);
  /// Returns the probe to a former state; this is no gesture.
  void restore(const ProbePlacementState& state);

  const ProbePlacement* hand() const { return hand_ ? &*hand_ : nullptr; }
  HandNumbers numbers() const { return hand_ ? numbersOf(hand_->state()) : HandNumbers{}; }

 private:
  template <class Move>
  MoveResult done(const Move& move);

  std::optional<ProbePlacement> hand_;
  std::function<void(const ProbePlacementState&)> gestureBegan_;
  bool gestureOpen_ = false;
};

}  // namespace insonate::train
