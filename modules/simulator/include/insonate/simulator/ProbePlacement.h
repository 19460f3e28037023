#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/Volume.h>

#include <memory>
#include <string_view>

namespace insonate {

/// Position and angles of a ProbePlacement: its complete state, for saving and restoring. Patient LPS.
struct ProbePlacementState {
  Vec3 skin_mm;  ///< point of the skin under the middle of the probe's face, even if the probe is lifted
  Vec3 inward;   ///< unit direction into the body, perpendicular to the skin
  Vec3 lateral;  ///< unit direction toward the probe's marker, along the skin
  /// tilt (fanning), rotation about the lateral axis (x); positive: the beam turns toward -y (elevation)
  double tilt_deg = 0;
  /// rock (heel-toe), rotation about the elevation axis (y); positive: the beam turns toward the marker (x)
  double rock_deg = 0;
  /// depth of the face below the skin, along the probe's axis; positive: pressed into the skin; negative: off the skin
  double press_mm = 0;
  bool operator==(const ProbePlacementState&) const = default;
};

/// Returns the probe's rotation about the skin's normal, -180 to 180 degrees. At 0, the image is transverse; if the
/// probe points to the patient's back, the marker then points to the patient's left. Positive: the probe is turned from
/// lateral (x) toward elevation (y).
double rotationOf_deg(const ProbePlacementState& state);

/// Outcome of a move of probe or needle; allocates no memory.
struct MoveResult {
  std::string_view stopped;  ///< sentence that says why the move stopped early; empty: the move was completed
  bool done() const { return stopped.empty(); }
};

class HapticSession;
class NeedlePlacement;
class SkinSurface;

/// Position of a probe that mouse and keys move over the skin. The probe is perpendicular to the skin, except for tilt
/// and rock. A move stops at the end of the skin or of the patient's volume; its result says why. No move allocates
/// memory or takes more than a fraction of a millisecond. Copies share the skin surface. One object must not be used
/// concurrently.
class ProbePlacement {
 public:
  static constexpr double kMaxAngle_deg = 60;  ///< maximum tilt and maximum rock, to either side
  static constexpr double kMaxPress_mm = 20;
  /// distance of a lifted probe from the skin; the probe receives no echoes there
  static constexpr double kLift_mm = 20;

  /// Makes a probe on the patient's skin, at the pose that setPose() would set. The skin is the outer boundary of all
  /// labels except background. Takes some tenths of a second for a large volume. Fails if the label map has only
  /// background or none, if its size does not match its voxels, or if the pose is not rigid.
  static Result<ProbePlacement> make(const LabelMap& labels, const Transform& patientFromProbe);

  /// Slides the probe over the skin by any distance, along its lateral and elevation directions.
  MoveResult slide(double lateral_mm, double elevation_mm);
  /// Rotates the probe about its axis; positive: from lateral (x) toward elevation (y).
  MoveResult rotate(double degrees);
  MoveResult tilt(double degrees);
  MoveResult rock(double degrees);
  /// Compresses the tissue with the probe by another `mm`; negative: by less. A lifted probe is first put on the skin.
  MoveResult press(double mm);
  /// Lifts the probe off the skin by kLift_mm, along its axis. Other moves then keep it lifted; press() and moveTo()
  /// put it back on the skin.
  void lift();
  /// Moves the probe to the point of the skin nearest to `patient_mm`. Rotation (rotationOf_deg()), tilt and rock do
  /// not change. Where the skin is nearly perpendicular to the body's long axis, the probe keeps its orientation as far
  /// as possible instead of its rotation.
  MoveResult moveTo(Vec3 patient_mm);
  /// Moves the probe as moveTo() does, sets its rotation and removes the compression. The resulting pose depends only
  /// on the arguments, not on the previous pose.
  MoveResult placeAt(Vec3 patient_mm, double rotation_deg);
  /// Sets the probe's pose. The probe gets exactly this pose if its angles are within the limits and the probe's axis
  /// meets the skin within 60 mm; otherwise it gets the nearest permitted pose, and the result says so. A pose that is
  /// not rigid changes nothing.
  MoveResult setPose(const Transform& patientFromProbe);

  /// Returns the rigid transform patientFromProbe, in the form that ultrasound engines take.
  Transform pose() const;

  const ProbePlacementState& state() const { return state_; }
  /// Restores a state of the probe that was saved for the same patient. With the state of another patient, the probe
  /// may be off the skin. A state that is not finite changes nothing.
  void restore(const ProbePlacementState& state);

 private:
  friend class HapticSession;  // HapticSession and ProbePlacement use the same skin
  friend class NeedlePlacement;
  ProbePlacement(std::shared_ptr<const SkinSurface> skin) : skin_(std::move(skin)) {}

  std::shared_ptr<const SkinSurface> skin_;
  ProbePlacementState state_;
};

}  // namespace insonate
