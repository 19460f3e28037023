#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/Volume.h>

#include <memory>
#include <string_view>

namespace insonate {

/// Position and angles of the probe in a ProbeHand: the complete state to save, compare and restore. Patient LPS.
struct ProbeHandState {
  Vec3 skin_mm;         ///< point at which the middle of the face touches the skin; if lifted, would touch it
  Vec3 inward;          ///< into the body, perpendicular to the skin, unit
  Vec3 lateral;         ///< toward the probe's marker, along the skin, unit
  double tilt_deg = 0;  ///< fan, about lateral: above 0, the beam turns against elevation (y)
  double rock_deg = 0;  ///< tilt (fan), about lateral: above 0, the beam turns against elevation (y)
  double press_mm = 0;  ///< along the probe's axis: above 0 into the skin, below 0 off it
  bool operator==(const ProbeHandState&) const = default;
};

/// Outcome of a move; allocates no memory.
struct HandMove {
  std::string_view stopped;  ///< a sentence that says why the move was not completed; empty if it was
  bool done() const { return stopped.empty(); }
};

class HandsSession;
class NeedleHand;
class SkinSurface;

/// A probe held on the skin without a device. It stays perpendicular to the skin except for the user's own tilt and
/// rock. A move stops at the end of the skin or of the patient's volume, and says why. No move allocates, and none
/// takes longer than a fraction of a millisecond. Copies share the skin. Not for concurrent use of one object.
class ProbeHand {
 public:
  static constexpr double kMostAngle_deg = 60;  ///< maximum of tilt and of rock, to either side
  static constexpr double kMostPress_mm = 20;
  static constexpr double kLift_mm = 20;  ///< distance off the skin at which the probe receives no echoes

  /// Makes a hand. The skin is the outer boundary of the labels other than background. `patientFromProbe` is applied
  /// as by setPose(). Takes some tenths of a second for a large volume. Fails if the label map has no body or no
  /// outside, if its size does not match its voxels, or if the pose is not rigid.
  static Result<ProbeHand> make(const LabelMap& labels, const Transform& patientFromProbe);

  /// Slides over the skin by any distance, along the probe's own directions.
  HandMove slide(double lateral_mm, double elevation_mm);
  /// Rotates about the probe's axis, from lateral toward elevation.
  HandMove rotate(double degrees);
  HandMove tilt(double degrees);
  HandMove rock(double degrees);
  /// Presses the probe further in; below 0: less far. A lifted probe is put on the skin first.
  HandMove press(double mm);
  /// Lifts the probe off the skin, along its axis. The other moves then work above the skin; press() and moveTo() put
  /// the probe back on the skin.
  void lift();
  /// Moves to the skin point nearest to a point in or around the patient; the angles stay.
  HandMove moveTo(Vec3 patient_mm);
  /// Applies a pose: pose() returns it exactly if it is within the limits and the probe's axis meets the skin within 60
  /// mm; otherwise the nearest permitted pose is taken, and the outcome says so. Poses that are not rigid are refused
  /// and change nothing.
  HandMove setPose(const Transform& patientFromProbe);

  /// patientFromProbe, as engines take it.
  Transform pose() const;

  const ProbeHandState& state() const { return state_; }
  /// Restores a state of this patient. If the state is of another patient, the probe ends up in the air. A state that
  /// is not finite changes nothing.
  void restore(const ProbeHandState& state);

 private:
  friend class HandsSession;  // HandsSession and ProbeHand use the same skin
  friend class NeedleHand;
  ProbeHand(std::shared_ptr<const SkinSurface> skin) : skin_(std::move(skin)) {}

  std::shared_ptr<const SkinSurface> skin_;
  ProbeHandState state_;
};

}  // namespace insonate
