#include "RigidPose.h"
#include "hand/SkinSurface.h"

#include <insonate/simulator/ProbePlacement.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

constexpr double kStep_mm = 1;        // length of a step of a slide
constexpr double kStepReach_mm = 8;   // maximum rise or fall of the skin within a step
constexpr double kPoseReach_mm = 60;  // maximum distance from a given pose to the skin
constexpr double kRotationStep_deg = 2;
constexpr double kDegree = std::numbers::pi / 180;

constexpr MoveResult kDone{};
constexpr MoveResult kNoNumber{"The move is not a finite number."};
constexpr MoveResult kVolumeEnds{"The scan ends here. Move the probe back or in another direction."};
constexpr MoveResult kSkinEnds{
    "The skin ends or turns away here. Move the probe in another direction, or click on the skin where the probe "
    "should be."};
constexpr MoveResult kMaxTilt{
    "The probe is tilted or rocked to its limit, 60 degrees from the perpendicular to the skin."};
constexpr MoveResult kMaxPressed{"The probe compresses the tissue to its limit, 20 mm."};
constexpr MoveResult kMinPressed{"The probe touches the skin without compressing it. Lift the probe to remove it."};
constexpr MoveResult kNotRigid{"The pose is not a rotation with a position."};
constexpr MoveResult kAwayFromSkin{
    "The pose does not point at the skin. The probe was put on the nearest skin instead."};
constexpr MoveResult kPoseLimited{"The pose is out of range. The probe is at the nearest possible pose."};

Mat3 aboutX(double degrees) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  return {{Vec3{1, 0, 0}, Vec3{0, c, s}, Vec3{0, -s, c}}};
}
Mat3 aboutY(double degrees) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  return {{Vec3{c, 0, -s}, Vec3{0, 1, 0}, Vec3{s, 0, c}}};
}
Mat3 aboutZ(double degrees) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  return {{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, 1}}};
}

/// Axes of a probe perpendicular to the skin: lateral, elevation, axial.
Mat3 squareTo(const ProbePlacementState& state) {
  return {{state.lateral, cross(state.inward, state.lateral), state.inward}};
}

Mat3 heldAs(const ProbePlacementState& state) {
  return squareTo(state) * aboutX(state.tilt_deg) * aboutY(state.rock_deg);
}

/// Rotates the probe with the skin by the smallest rotation, so that a path there and back leaves its marker where it
/// was.
void turnTo(Vec3 inward, ProbePlacementState& state) {
  const Vec3 axis = cross(state.inward, inward);
  const double cosine = dot(state.inward, inward);
  Vec3 lateral = state.lateral;
  if (cosine > -0.999) lateral = lateral * cosine + cross(axis, lateral) + axis * (dot(axis, lateral) / (1 + cosine));
  state.inward = inward;
  state.lateral = normalized(lateral - inward * dot(lateral, inward));
}

constexpr Vec3 kHead{0, 0, 1};

/// Within 30 degrees of the body's long axis.
bool isAlongBody(Vec3 inward) {
  constexpr double kSin30 = 0.5;
  return norm(cross(inward, kHead)) < kSin30;
}

/// Lateral direction of a transverse image: at right angles to the body's long axis, along the skin. Where the skin is
/// nearly at right angles to that axis, as on the shoulder, toward the patient's left.
Vec3 transverse(Vec3 inward) {
  if (isAlongBody(inward)) return normalized(Vec3{1, 0, 0} - inward * inward.x);
  return normalized(cross(inward, kHead));
}

Vec3 lateralAt(Vec3 inward, double rotation_deg) {
  const Vec3 across = transverse(inward);
  return across * std::cos(rotation_deg * kDegree) + cross(inward, across) * std::sin(rotation_deg * kDegree);
}

/// Tilt, rock and lateral direction of a probe held as `patientFromProbe`: its rotation relative to the skin is
/// Z(heading) X(tilt) Y(rock).
void takeRotation(const Mat3& patientFromProbe, ProbePlacementState& state) {
  const auto& [x, y, z] = patientFromProbe.column;
  state.tilt_deg = std::asin(std::clamp(dot(state.inward, y), -1.0, 1.0)) / kDegree;
  state.rock_deg = std::atan2(-dot(state.inward, x), dot(state.inward, z)) / kDegree;
  const Vec3 lateral = patientFromProbe * (transposed(aboutX(state.tilt_deg) * aboutY(state.rock_deg)) * Vec3{1, 0, 0});
  state.lateral = normalized(lateral - state.inward * dot(lateral, state.inward));
}

bool withinAngles(const ProbePlacementState& state) {
  constexpr double kMost = ProbePlacement::kMaxAngle_deg + 1e-9;
  return std::abs(state.tilt_deg) <= kMost && std::abs(state.rock_deg) <= kMost;
}

MoveResult turned(double& angle_deg, double by_deg) {
  if (!std::isfinite(by_deg)) return kNoNumber;
  const double wanted = angle_deg + by_deg;
  angle_deg = std::clamp(wanted, -ProbePlacement::kMaxAngle_deg, ProbePlacement::kMaxAngle_deg);
  return wanted == angle_deg ? kDone : kMaxTilt;
}

}  // namespace

double rotationOf_deg(const ProbePlacementState& state) {
  const Vec3 across = transverse(state.inward);
  return std::atan2(dot(state.lateral, cross(state.inward, across)), dot(state.lateral, across)) / kDegree;
}

Result<ProbePlacement> ProbePlacement::make(const LabelMap& labels, const Transform& patientFromProbe) {
  auto skin = SkinSurface::make(labels);
  if (!skin) return tl::unexpected(skin.error());
  if (!isRigid(patientFromProbe)) return fail(std::string(kNotRigid.stopped));
  ProbePlacement hand(std::make_shared<const SkinSurface>(std::move(*skin)));
  hand.setPose(patientFromProbe);
  return hand;
}

MoveResult ProbePlacement::slide(double lateral_mm, double elevation_mm) {
  const double length_mm = std::hypot(lateral_mm, elevation_mm);
  if (!(length_mm < 1e4)) return kNoNumber;
  const int steps = static_cast<int>(std::ceil(length_mm / kStep_mm));
  for (int step = 0; step < steps; ++step) {
    const auto& [lateral, elevation, inward] = squareTo(state_).column;
    const Vec3 ahead = state_.skin_mm + (lateral * lateral_mm + elevation * elevation_mm) / steps;
    const auto skin = skin_->along(ahead, -inward, kStepReach_mm);
    if (!skin) return kSkinEnds;
    if (!skin_->inVolume(*skin)) return kVolumeEnds;
    state_.skin_mm = *skin;
    turnTo(-skin_->normal(*skin, -inward), state_);
  }
  return kDone;
}

MoveResult ProbePlacement::rotate(double degrees) {
  if (!(std::abs(degrees) < 1e6)) return kNoNumber;
  degrees = std::remainder(degrees, 360);
  const int steps = static_cast<int>(std::ceil(std::abs(degrees) / kRotationStep_deg));
  const Mat3 before = heldAs(state_);
  for (int step = 1; step <= steps; ++step) {
    ProbePlacementState next = state_;
    takeRotation(before * aboutZ(degrees * step / steps), next);
    if (!withinAngles(next)) return kMaxTilt;
    state_ = next;
  }
  return kDone;
}

MoveResult ProbePlacement::tilt(double degrees) {
  return turned(state_.tilt_deg, degrees);
}

MoveResult ProbePlacement::rock(double degrees) {
  return turned(state_.rock_deg, degrees);
}

MoveResult ProbePlacement::press(double mm) {
  if (!std::isfinite(mm)) return kNoNumber;
  const double wanted_mm = std::max(state_.press_mm, 0.0) + mm;
  state_.press_mm = std::clamp(wanted_mm, 0.0, kMaxPress_mm);
  if (wanted_mm == state_.press_mm) return kDone;
  return wanted_mm < 0 ? kMinPressed : kMaxPressed;
}

void ProbePlacement::lift() {
  state_.press_mm = std::min(state_.press_mm, -kLift_mm);
}

MoveResult ProbePlacement::moveTo(Vec3 patient_mm) {
  if (!isFinite(patient_mm)) return kNoNumber;
  const double rotation_deg = rotationOf_deg(state_);
  const bool wasAlongBody = isAlongBody(state_.inward);
  state_.skin_mm = skin_->nearest(patient_mm);
  turnTo(-skin_->normal(state_.skin_mm, -state_.inward), state_);
  // A drag over the shoulder turns the probe as little as possible; elsewhere the rotation is that of the place.
  if (!wasAlongBody && !isAlongBody(state_.inward)) state_.lateral = lateralAt(state_.inward, rotation_deg);
  state_.press_mm = std::max(state_.press_mm, 0.0);
  return kDone;
}

MoveResult ProbePlacement::placeAt(Vec3 patient_mm, double rotation_deg) {
  if (!isFinite(patient_mm) || !std::isfinite(rotation_deg)) return kNoNumber;
  state_.skin_mm = skin_->nearest(patient_mm);
  state_.inward = -skin_->normal(state_.skin_mm, -state_.inward);
  state_.lateral = lateralAt(state_.inward, rotation_deg);
  state_.press_mm = 0;
  return kDone;
}

MoveResult ProbePlacement::setPose(const Transform& patientFromProbe) {
  if (!isRigid(patientFromProbe)) return kNotRigid;
  const Vec3 axial = normalized(patientFromProbe.linear.column[2]);
  auto skin = skin_->along(patientFromProbe.offset, -axial, kPoseReach_mm);
  const bool found = skin && skin_->inVolume(*skin);
  ProbePlacementState next;
  next.skin_mm = found ? *skin : skin_->nearest(patientFromProbe.offset);
  next.inward = -skin_->normal(next.skin_mm, -axial);
  takeRotation(patientFromProbe.linear, next);
  if (found) next.press_mm = dot(patientFromProbe.offset - next.skin_mm, axial);

  const bool fits = withinAngles(next) && next.press_mm <= kMaxPress_mm;
  next.tilt_deg = std::clamp(next.tilt_deg, -kMaxAngle_deg, kMaxAngle_deg);
  next.rock_deg = std::clamp(next.rock_deg, -kMaxAngle_deg, kMaxAngle_deg);
  next.press_mm = std::min(next.press_mm, kMaxPress_mm);
  state_ = next;
  if (!found) return kAwayFromSkin;
  return fits ? kDone : kPoseLimited;
}

Transform ProbePlacement::pose() const {
  const Mat3 rotation = heldAs(state_);
  return {rotation, state_.skin_mm + rotation.column[2] * state_.press_mm};
}

void ProbePlacement::restore(const ProbePlacementState& state) {
  const bool finite = std::isfinite(state.tilt_deg) && std::isfinite(state.rock_deg) && std::isfinite(state.press_mm);
  if (finite && isRigid({squareTo(state), state.skin_mm})) state_ = state;
}

}  // namespace insonate
