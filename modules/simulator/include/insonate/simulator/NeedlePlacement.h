#pragma once

#include <insonate/core/Transform.h>
#include <insonate/simulator/ProbePlacement.h>

#include <memory>
#include <optional>

namespace insonate {

/// Position and angles of the needle in a NeedlePlacement. Patient LPS.
struct NeedlePlacementState {
  Vec3 entry_mm;          ///< point on the skin at which the needle enters or will enter
  Vec3 inward{0, 1, 0};   ///< unit direction into the body, perpendicular to the skin
  Vec3 heading{1, 0, 0};  ///< unit direction of the projection of the needle onto the skin
  double angle_deg = 45;  ///< angle between needle and skin; 90: perpendicular to the skin
  /// distance of the tip beyond the entry point, along the needle; negative: the tip is outside the skin
  double advance_mm = -5;
  double bevel_deg = 0;  ///< rotation about the needle's axis; 0: the bevel faces away from the skin
  /// Unit normal of the image plane in which moves keep the needle; empty: moves do not keep the needle in a plane.
  std::optional<Vec3> planeNormal{};
  bool operator==(const NeedlePlacementState&) const = default;
};

/// Position of a new needle relative to the image plane.
enum class NeedlePlane { InPlane, OutOfPlane };

/// Geometry of a needle that mouse and keys move: entry point on the skin, angles and advance. While the tip is in the
/// body, the entry point is fixed, and the needle can turn about the entry point only up to the depth kTurnsUntil_mm of
/// the tip. HapticSession computes the contacts with tissue. No move allocates. One object must not be used
/// concurrently.
class NeedlePlacement {
 public:
  static constexpr double kMinAngle_deg = 5, kMaxAngle_deg = 90;
  static constexpr double kMaxOff_mm = 40, kLength_mm = 70;
  /// Depth of the tip up to which the needle can turn about its entry point. At greater depths, the tissue holds the
  /// needle on its track; the force loop constrains the needle to a line from the same depth on.
  static constexpr double kTurnsUntil_mm = 10;

  /// Angle between a new needle and the skin. All targets require a steeper angle, so that the trainee has to aim.
  static constexpr double kInitialAngle_deg = 20;

  /// Places a needle beside a probe, outside the skin, at the angle kInitialAngle_deg to the skin. InPlane: the needle
  /// lies in the image plane, at an end of the probe's face. If the shape of the skin allows that at neither end, the
  /// needle is placed as for OutOfPlane. OutOfPlane: the needle is beside the middle of the face. `halfWidth_mm`: half
  /// the width of the face.
  ///
  /// `toward` is a unit direction (patient LPS) in which the needle shall point, for example along the vein to the
  /// heart, so that a wire leads there. It decides between the two ends or sides of the probe. If it is empty or nearly
  /// perpendicular to that axis of the probe, InPlane is at the end opposite the marker, and OutOfPlane on the side of
  /// the probe's elevation axis. If there is no skin at one end of the face, InPlane is at the other one.
  static NeedlePlacement makeBeside(const ProbePlacement& probe, double halfWidth_mm, NeedlePlane plane,
                                    std::optional<Vec3> toward);

  /// Moves the entry point over the skin along the probe's lateral and elevation directions. Has no effect while the
  /// tip is in the body. An in-plane needle stays in-plane if elevation_mm is 0, at the same angle to the skin.
  /// Any other needle keeps its direction in space, as far as its angles allow.
  MoveResult slide(const Transform& patientFromProbe, double lateral_mm, double elevation_mm);
  /// Moves the entry point to the point of the skin nearest to `patient_mm`. Has no effect while the tip is in the
  /// body. An in-plane needle leaves the image plane.
  MoveResult moveTo(Vec3 patient_mm);
  /// Turns the needle about the skin's normal; positive: from `heading` toward `inward` x `heading`
  /// (NeedlePlacementState). An in-plane needle leaves the image plane.
  MoveResult turn(double degrees);
  /// Changes the angle between needle and skin; positive: steeper. An in-plane needle stays in-plane.
  MoveResult tilt(double degrees);
  /// Rotates the needle about its axis.
  MoveResult rotateBevel(double degrees);
  /// Advances the needle along its axis; negative: withdraws it.
  MoveResult advance(double mm);

  /// Returns the needle's pose in patient space: the tip is the origin, z points along the needle toward the tip, and
  /// the bevel faces -y.
  Transform patientFromNeedle() const;

  const NeedlePlacementState& state() const { return state_; }
  /// Tells whether the needle's tip is in the body.
  bool isInBody() const { return state_.advance_mm > 0; }

  /// Returns the maximum distance from the image plane of the points on the needle's axis, from the entry point to the
  /// needle's full length.
  double offPlane_mm(const Transform& patientFromProbe) const;

  /// Returns the direction of the needle along the skin, in degrees: 0 toward the patient's head, 90 toward the
  /// patient's left.
  double heading_deg() const;

 private:
  NeedlePlacement(std::shared_ptr<const SkinSurface> skin) : skin_(std::move(skin)) {}
  MoveResult put(Vec3 skin_mm);
  bool putInPlane(const Transform& patientFromProbe, Vec3 from_mm, Vec3 toward);
  bool point(double angle_deg, Vec3 toward);

  std::shared_ptr<const SkinSurface> skin_;
  NeedlePlacementState state_;
};

}  // namespace insonate
