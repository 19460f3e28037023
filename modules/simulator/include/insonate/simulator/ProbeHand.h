#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/Volume.h>

#include <memory>
#include <string_view>

namespace insonate {

/// Position and angles of a ProbeHand: its complete state, for saving and restoring. Patient LPS.
struct ProbeHandState {
  Vec3 skin_mm;  ///< skin point under the middle of the probe's face; also for a lifted probe
  Vec3 inward;   ///< unit direction into the body, perpendicular to the skin
  Vec3 lateral;  ///< unit direction toward the probe's marker, along the skin
  /// tilt (fan), rotation about the lateral axis (x); above 0: the beam turns toward -y (elevation)
  double tilt_deg = 0;
  /// rock (heel-toe), rotation about the elevation axis (y); above 0: the beam turns toward the marker (x)
  double rock_deg = 0;
  /// depth of the face along the probe's axis; above 0: pressed into the skin, below 0: off the skin
  double press_mm = 0;
  bool operator==(const ProbeHandState&) const = default;
};

/// Returns the probe's rotation about the skin's normal, -180 to 180 degrees. 0: the image is transverse, with the
/// marker toward the patient's left if the probe points backward; above 0: turned from lateral (x) toward elevation
/// (y).
double rotationOf_deg(const ProbeHandState& state);

/// Outcome of a move of probe or needle; allocates no memory.
struct HandMove {
  std::string_view stopped;  ///< a sentence that says why the move was stopped early; empty: the move was completed
  bool done() const { return stopped.empty(); }
};

class HandsSession;
class NeedleHand;
class SkinSurface;

/// Position of a probe on the skin that is moved by mouse and keys. The probe stays perpendicular to the skin except
/// for tilt and rock. A move stops at the end of the skin or of the patient's volume, and its result says why. No move
/// allocates, or takes longer than a fraction of a millisecond. Copies share the skin surface. Not for concurrent use
/// of one object.
class ProbeHand {
 public:
  static constexpr double kMostAngle_deg = 60;  ///< maximum tilt and maximum rock, to either side
  static constexpr double kMostPress_mm = 20;
  /// distance of a lifted probe from the skin; the probe receives no echoes there
  static constexpr double kLift_mm = 20;

  /// Places a probe on the skin, which is the outer boundary of all labels except background; the pose is applied as by
  /// setPose(). Takes some tenths of a second for a large volume. Fails if the label map has only background or none,
  /// if its size does not match its voxels, or if the pose is not rigid.
  static Result<ProbeHand> make(const LabelMap& labels, const Transform& patientFromProbe);

  /// Slides the probe over the skin by any distance, along its lateral and elevation directions.
  HandMove slide(double lateral_mm, double elevation_mm);
  /// Rotates the probe about its axis; above 0: from lateral (x) toward elevation (y).
  HandMove rotate(double degrees);
  HandMove tilt(double degrees);
  HandMove rock(double degrees);
  /// Presses the probe further into the skin; below 0: less far. A lifted probe is put on the skin first.
  HandMove press(double mm);
  /// Lifts the probe off the skin by kLift_mm, along its axis. Other moves then keep it lifted; press() and moveTo()
  /// put it back on the skin.
  void lift();
  /// Moves the probe to the skin point nearest to `patient_mm`; rotation (rotationOf_deg), tilt and rock stay. On skin
  /// that is nearly at right angles to the body's long axis, the probe is turned as little as possible instead.
  HandMove moveTo(Vec3 patient_mm);
  /// As moveTo(), but with this rotation and without compression: the pose depends on the place only, not on the path
  /// to it.
  HandMove stand(Vec3 patient_mm, double rotation_deg);
  /// Sets the probe's pose. The pose is taken exactly if its angles are within the limits and the probe's axis meets
  /// the skin within 60 mm; otherwise the nearest permitted pose is taken, and the result says so. A pose that is not
  /// rigid changes nothing.
  HandMove setPose(const Transform& patientFromProbe);

  /// Returns the rigid transform patientFromProbe, as ultrasound engines take it.
  Transform pose() const;

  const ProbeHandState& state() const { return state_; }
  /// Restores a saved state of the probe on this patient. A state of another patient may put the probe off the skin. A
  /// state that is not finite changes nothing.
  void restore(const ProbeHandState& state);

 private:
  friend class HandsSession;  // HandsSession and ProbeHand use the same skin
  friend class NeedleHand;
  ProbeHand(std::shared_ptr<const SkinSurface> skin) : skin_(std::move(skin)) {}

  std::shared_ptr<const SkinSurface> skin_;
  ProbeHandState state_;
};

}  // namespace insonate
