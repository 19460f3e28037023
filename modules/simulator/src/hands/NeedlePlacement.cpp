#include "hand/SkinSurface.h"

#include <insonate/simulator/NeedlePlacement.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSkinReach_mm = 30;
/// Cosine between normals of planes that count as the same.
constexpr double kSamePlane = 0.9999;
/// Sine of the angle to the steepest direction of a plane; slightly beside it, so that the needle keeps its side.
constexpr double kMaxSine = 0.9999;
/// Cosine between a direction and an axis of the probe from which on the direction decides between its two sides.
constexpr double kDecides = 0.25;
/// Distance from the housing to a needle beside it.
constexpr double kBesideFace_mm = 5, kBesideHousing_mm = 12;

constexpr MoveResult kDone{};
constexpr MoveResult kNoNumber{"The move is not a finite number."};
constexpr MoveResult kIsIn{"The needle is in the skin. Withdraw the needle before you insert it at another point."};
constexpr MoveResult kHeld{
    "The tissue prevents the needle from turning. Withdraw the needle to an insertion length of 10 mm to redirect it."};
constexpr MoveResult kFlat{"The needle is at its smallest angle to the skin, 5 degrees."};
constexpr MoveResult kSteepest{"At this skin, the needle cannot be steeper within the image plane."};
constexpr MoveResult kSquare{
    "The needle is perpendicular to the skin. Change the heading of the needle to tilt it the other way."};
constexpr MoveResult kHub{"The needle is inserted up to its hub (70 mm)."};
constexpr MoveResult kOff{"The needle is 40 mm off the skin, which is the limit. Press I to put the needle away."};
constexpr MoveResult kVolumeEnds{"The scan ends here, so the needle stays where it is."};

/// Rotates `v` about the unit vector `axis` (Rodrigues).
Vec3 turned(Vec3 v, Vec3 axis, double degrees) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

/// Direction along the skin toward the head; another one if that is undefined.
Vec3 towardHead(Vec3 inward) {
  const Vec3 head{0, 0, 1}, back{0, 1, 0};
  const Vec3 along = head - inward * dot(inward, head);
  return normalized(norm(along) > 1e-3 ? along : back - inward * dot(inward, back));
}

Vec3 along(Vec3 direction, Vec3 inward, Vec3 otherwise) {
  const Vec3 flat = direction - inward * dot(direction, inward);
  return norm(flat) > 1e-6 ? normalized(flat) : towardHead(otherwise);
}

}  // namespace

NeedlePlacement NeedlePlacement::makeBeside(const ProbePlacement& probe, double halfWidth_mm, NeedlePlane plane,
                                            std::optional<Vec3> toward) {
  NeedlePlacement needle(probe.skin_);
  const Transform pose = probe.pose();
  const auto& [lateral, elevation, axial] = pose.linear.column;
  const bool isAlong = plane == NeedlePlane::InPlane;
  const Vec3 way = toward.value_or(Vec3{});
  const Vec3 aside = isAlong ? lateral * (halfWidth_mm + kBesideFace_mm) * (dot(way, lateral) < -kDecides ? 1 : -1)
                             : elevation * kBesideHousing_mm * (dot(way, elevation) > kDecides ? -1 : 1);
  needle.state_.inward = probe.state().inward;
  needle.state_.angle_deg = kInitialAngle_deg;
  // If the scan ends there, the needle starts under the probe.
  needle.state_.entry_mm = probe.state().skin_mm;
  if (isAlong &&
      (needle.putInPlane(pose, pose.offset + aside, -aside) || needle.putInPlane(pose, pose.offset - aside, aside)))
    return needle;
  needle.state_.planeNormal.reset();
  needle.put(pose.offset + aside);
  needle.state_.heading = along(-aside, needle.state_.inward, needle.state_.inward);
  return needle;
}

/// Searches for the entry along the probe's axis, since the normal of the skin leaves the image plane where the skin is
/// inclined to it. Changes nothing and returns false if there is no skin, or if no direction in the plane has the
/// needle's angle to the skin.
bool NeedlePlacement::putInPlane(const Transform& pose, Vec3 from_mm, Vec3 toward) {
  const auto& [lateral, elevation, axial] = pose.linear.column;
  const auto entry = skin_->along(from_mm, -axial, kSkinReach_mm);
  if (!entry || !skin_->inVolume(*entry)) return false;
  const NeedlePlacementState before = state_;
  state_.entry_mm = *entry;
  state_.inward = -skin_->normal(*entry, -state_.inward);
  state_.planeNormal = elevation;
  if (point(state_.angle_deg, toward)) return true;
  state_ = before;
  return false;
}

/// Sets heading and angle to the direction with this angle to the skin, in the plane of planeNormal if there is one, on
/// the side of `toward`. If the plane has no direction as steep, takes its steepest and returns false.
bool NeedlePlacement::point(double angle_deg, Vec3 toward) {
  if (state_.planeNormal) {
    const Vec3 normal = *state_.planeNormal;
    const Vec3 steepest = state_.inward - normal * dot(state_.inward, normal);
    const double wanted = std::sin(angle_deg * kDegree) / norm(steepest), sine = std::min(wanted, kMaxSine);
    const Vec3 up = normalized(steepest), aside = cross(normal, up) * (dot(cross(normal, up), toward) < 0 ? -1 : 1);
    const Vec3 way = up * sine + aside * std::sqrt(1 - sine * sine);
    state_.heading = along(way, state_.inward, state_.inward);
    state_.angle_deg = std::asin(std::min(dot(way, state_.inward), 1.0)) / kDegree;
    return wanted <= 1;
  }
  state_.angle_deg = angle_deg;
  return true;
}

double NeedlePlacement::offPlane_mm(const Transform& patientFromProbe) const {
  const Transform probeFromNeedle = inverted(patientFromProbe) * patientFromNeedle();
  const double fromTip_mm = state_.advance_mm;
  const Vec3 entry = probeFromNeedle * Vec3{0, 0, -fromTip_mm},
             end = probeFromNeedle * Vec3{0, 0, kLength_mm - fromTip_mm};
  return std::max(std::abs(entry.y), std::abs(end.y));
}

MoveResult NeedlePlacement::put(Vec3 skin_mm) {
  const auto there = skin_->along(skin_mm, -state_.inward, kSkinReach_mm);
  const Vec3 entry = there ? *there : skin_->nearest(skin_mm);
  if (!skin_->inVolume(entry)) return kVolumeEnds;
  state_.entry_mm = entry;
  state_.inward = -skin_->normal(entry, -state_.inward);
  state_.heading = along(state_.heading, state_.inward, state_.inward);
  return kDone;
}

MoveResult NeedlePlacement::slide(const Transform& patientFromProbe, double lateral_mm, double elevation_mm) {
  if (!std::isfinite(lateral_mm) || !std::isfinite(elevation_mm)) return kNoNumber;
  if (isInBody()) return kIsIn;
  const auto& [lateral, elevation, axial] = patientFromProbe.linear.column;
  const Vec3 by = lateral * lateral_mm + elevation * elevation_mm;
  const bool isInPlane = state_.planeNormal && std::abs(dot(*state_.planeNormal, elevation)) > kSamePlane;
  if (isInPlane && elevation_mm == 0 && putInPlane(patientFromProbe, state_.entry_mm + by, state_.heading))
    return kDone;
  state_.planeNormal.reset();
  // The hand carries the needle along without turning it, so that its way through the image moves as the arrows do.
  const Vec3 axis = patientFromNeedle().linear.column[2];
  const MoveResult moved = put(state_.entry_mm + by - state_.inward * dot(by, state_.inward));
  if (!moved.done()) return moved;
  state_.angle_deg =
      std::clamp(std::asin(std::clamp(dot(axis, state_.inward), -1.0, 1.0)) / kDegree, kMinAngle_deg, kMaxAngle_deg);
  state_.heading = along(axis, state_.inward, state_.inward);
  return moved;
}

MoveResult NeedlePlacement::moveTo(Vec3 patient_mm) {
  if (!isFinite(patient_mm)) return kNoNumber;
  if (isInBody()) return kIsIn;
  state_.planeNormal.reset();
  return put(skin_->nearest(patient_mm));
}

MoveResult NeedlePlacement::turn(double degrees) {
  if (!std::isfinite(degrees)) return kNoNumber;
  if (state_.advance_mm > kTurnsUntil_mm) return kHeld;
  state_.planeNormal.reset();
  state_.heading = along(turned(state_.heading, state_.inward, degrees), state_.inward, state_.inward);
  return kDone;
}

MoveResult NeedlePlacement::tilt(double degrees) {
  if (!std::isfinite(degrees)) return kNoNumber;
  if (state_.advance_mm > kTurnsUntil_mm) return kHeld;
  const double wanted = state_.angle_deg + degrees;
  const bool isReached = point(std::clamp(wanted, kMinAngle_deg, kMaxAngle_deg), state_.heading);
  if (!isReached && wanted < kMaxAngle_deg) return kSteepest;
  return wanted < kMinAngle_deg ? kFlat : wanted > kMaxAngle_deg ? kSquare : kDone;
}

MoveResult NeedlePlacement::rotateBevel(double degrees) {
  if (!std::isfinite(degrees)) return kNoNumber;
  state_.bevel_deg = std::remainder(state_.bevel_deg + degrees, 360);
  return kDone;
}

MoveResult NeedlePlacement::advance(double mm) {
  if (!std::isfinite(mm)) return kNoNumber;
  const double wanted = state_.advance_mm + mm;
  state_.advance_mm = std::clamp(wanted, -kMaxOff_mm, kLength_mm);
  return wanted > kLength_mm ? kHub : wanted < -kMaxOff_mm ? kOff : kDone;
}

Transform NeedlePlacement::patientFromNeedle() const {
  const double angle = state_.angle_deg * kDegree;
  const Vec3 z = state_.heading * std::cos(angle) + state_.inward * std::sin(angle);
  // Bevel up: its direction is as close to the normal of the skin as the needle permits.
  const Vec3 y = turned(state_.inward * std::cos(angle) - state_.heading * std::sin(angle), z, state_.bevel_deg);
  return {{{cross(y, z), y, z}}, state_.entry_mm + z * state_.advance_mm};
}

double NeedlePlacement::heading_deg() const {
  const Vec3 head = towardHead(state_.inward);
  // From outside, the patient's left lies clockwise of the head at the front of the body, and so all around it.
  const Vec3 left = cross(state_.inward, head);
  return std::atan2(dot(state_.heading, left), dot(state_.heading, head)) / kDegree;
}

}  // namespace insonate
