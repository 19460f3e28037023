#pragma once

#include <insonate/core/Transform.h>
#include <insonate/simulator/ProbeHand.h>

#include <memory>
#include <optional>

namespace insonate {

/// Position and angles of the needle in a NeedleHand. Patient LPS.
struct NeedleHandState {
  Vec3 entry_mm;           ///< point on the skin at which the needle enters
  Vec3 inward{0, 1, 0};    ///< into the body, perpendicular to the skin, unit
  Vec3 heading{1, 0, 0};   ///< direction of the needle along the skin, unit
  double angle_deg = 45;   ///< between needle and skin; 90: perpendicular to the skin
  double advance_mm = -5;  ///< distance of the tip from the entry along the needle; below 0: off the skin
  double bevel_deg = 0;    ///< rotation about the needle's axis; 0: the bevel faces away from the skin
  /// Normal of the image plane in which the needle stays, unit; empty: it is bound to no plane.
  std::optional<Vec3> planeNormal{};
  bool operator==(const NeedleHandState&) const = default;
};

/// Alignment of a needle with the probe's plane.
enum class NeedlePlane { Along, Across };

/// A needle held without a device: described by an entry on the skin, angles and a depth. While the tip is in the body
/// the entry is fixed, and the needle turns about it only near the skin. The servo computes contacts, see
/// HandsSession.h. No move allocates. Not for concurrent use of one object.
class NeedleHand {
 public:
  static constexpr double kLeastAngle_deg = 5, kMostAngle_deg = 90;
  static constexpr double kMostOff_mm = 40, kLength_mm = 70;
  /// Depth of the tip up to which the needle can turn. If the tip is deeper, tissue holds the needle on its track,
  /// since the servo's line constraint begins there.
  static constexpr double kTurnsUntil_mm = 10;

  /// Angle of a newly taken needle. Every target needs a steeper angle, so that the trainee has to aim.
  static constexpr double kTaken_deg = 20;

  /// Makes a needle ready beside a probe, at kTaken_deg to the skin. Along: in the image plane, at the end of the face
  /// that is away from the marker. If the skin does not allow that (offPlane_mm()), the needle is placed as for Across.
  /// Across: in front of the face. `halfWidth_mm` is that of the face.
  static NeedleHand beside(const ProbeHand& probe, double halfWidth_mm, NeedlePlane plane);

  /// Moves the entry over the skin along the probe's own directions; no effect while the tip is in the body. A needle
  /// in-plane stays in-plane if elevation_mm is 0.
  HandMove slide(const Transform& patientFromProbe, double lateral_mm, double elevation_mm);
  HandMove moveTo(Vec3 patient_mm);
  /// Turns the needle about the skin's normal; above 0: from heading toward inward x heading. The needle leaves the
  /// image plane.
  HandMove turn(double degrees);
  /// Tilts the needle; above 0: steeper to the skin. A needle in-plane stays in-plane.
  HandMove tilt(double degrees);
  HandMove rotateBevel(double degrees);
  HandMove advance(double mm);

  /// Pose of the needle: its tip is the origin, z points along the needle toward the tip, and the bevel faces -y.
  Transform patientFromNeedle() const;

  const NeedleHandState& state() const { return state_; }
  bool isIn() const { return state_.advance_mm > 0; }

  /// Maximum distance of the shaft from the probe's image plane. The shaft counts from the entry to the needle's full
  /// length.
  double offPlane_mm(const Transform& patientFromProbe) const;

  /// Direction of the needle along the skin: 0 toward the patient's head, 90 toward the patient's left.
  double heading_deg() const;

 private:
  NeedleHand(std::shared_ptr<const SkinSurface> skin) : skin_(std::move(skin)) {}
  HandMove put(Vec3 skin_mm);
  bool putInPlane(const Transform& patientFromProbe, Vec3 from_mm, Vec3 toward);
  bool point(double angle_deg, Vec3 toward);

  std::shared_ptr<const SkinSurface> skin_;
  NeedleHandState state_;
};

}  // namespace insonate
