#include "needle/NeedleMechanics.h"

#include <algorithm>
#include <cmath>

namespace insonate::haptics {
namespace {

constexpr int kSkinWall = 0;
constexpr double kSubstep_mm = 0.25;
constexpr int kMaxSubsteps = 64;
constexpr double kJump_mm = 15;
/// Distance of the tip behind a hole from which the needle counts as withdrawn, so that a trembling hand punctures
/// once.
constexpr double kWithdrawn_mm = 0.3;
constexpr double kLetGo_mm = 0.05;
/// The tip slides along a wall if it is flatter than this (78 degrees off the normal); it catches again when steeper
/// than that (73).
constexpr double kSlideCosine = 0.2, kPrickCosine = 0.3;

}  // namespace

void NeedleMechanics::configure(const NeedleTable& table, double steepest_Npmm) {
  table_.tissues = table.tissues;  // does not copy the name, which would allocate
  steepest_Npmm_ = steepest_Npmm;
}

void NeedleMechanics::remove(std::int64_t time_ns, NeedleEvents& events) noexcept {
  if (!placed_) return;
  time_ns_ = time_ns;
  while (holeCount_ > 0) closeHole(events);
  placed_ = false;
  state_ = {};
  contacts_ = {};
  onBone_ = {};
}

void NeedleMechanics::place(const TissueGrid& grid, Vec3 tip, Vec3 axis) {
  inside_ = {};
  contacts_ = {};
  onBone_ = {};
  holeCount_ = 0;
  speed_mmps_ = 0;
  state_ = {};
  state_.track = axis;
  around_ = kSoftTissue;
  shaft_.restart();
  tip_ = before_ = tip;
  sample_ = grid.at(tip);
  placed_ = true;
}

NeedleForce NeedleMechanics::move(const TissueGrid& grid, const Transform& restFromPatient, Vec3 tip_mm, Vec3 axis,
                                  double step_s, std::int64_t time_ns, NeedleEvents& events) noexcept {
  if (!isFinite(tip_mm) || !isFinite(axis)) return {};
  const Vec3 tip = restFromPatient * tip_mm;
  const Vec3 restAxis = normalized(restFromPatient.linear * axis);
  const double way_mm = norm(tip - tip_);
  if (way_mm > kJump_mm) remove(time_ns, events);
  patientTip_ = tip_mm;
  patientAxis_ = axis;
  time_ns_ = time_ns;
  if (!placed_) place(grid, tip, restAxis);
  const Vec3 from = tip_;
  const int steps = std::clamp(static_cast<int>(std::ceil(way_mm / kSubstep_mm)), 1, kMaxSubsteps);
  for (int i = 1; i <= steps; ++i) step(grid, from + (tip - from) * (double(i) / steps), restAxis, events);
  // Smoothed over 10 ms: the speed of one tick mostly shows the encoders' steps.
  const double fresh = step_s > 0 ? dot(tip - from, restAxis) / step_s : 0;
  speed_mmps_ += (fresh - speed_mmps_) * std::clamp(step_s / 0.01, 0.0, 1.0);
  NeedleForce force = resist(restAxis, speed_mmps_);
  // A force on tissue at rest acts on the hand through the map that moved the tip there (virtual work).
  const Mat3 back = transposed(restFromPatient.linear);
  return {back * force.force_N, back * force.torque_Nmm, back * force.viscous_N};
}

bool NeedleMechanics::acts(int wall) const {
  const NeedleWall kind = table_.of(kNeedleWalls[wall]).wall;
  return kind != NeedleWall::None && (wall == kSkinWall || inside_[kSkinWall]);
}

void NeedleMechanics::step(const TissueGrid& grid, Vec3 tip, Vec3 axis, NeedleEvents& events) {
  before_ = tip_;
  tip_ = tip;
  withdraw(tip, events);
  const TissueSample sample = grid.at(tip);
  for (int wall = 0; wall < kNeedleWallCount; ++wall)
    if (acts(wall)) touch(grid, sample, wall, tip, axis, events);
  track(sample, tip, axis);
  sample_ = sample;
}

void NeedleMechanics::withdraw(Vec3 tip, NeedleEvents& events) {
  while (holeCount_ > 0) {
    if (dot(tip - holes_[holeCount_ - 1].point, state_.track) > -kWithdrawn_mm) return;
    closeHole(events);
  }
}

/// Closes the hole through which the tip has withdrawn.
void NeedleMechanics::closeHole(NeedleEvents& events) {
  const Hole hole = holes_[--holeCount_];
  const bool skin = hole.wall == kSkinWall;
  inside_[hole.wall] = !hole.inwards;
  contacts_[hole.wall].active = false;
  const bool full = events.count + 1 >= static_cast<int>(events.list.size());
  if (full && !skin)
    ++events.lost;  // the last place is reserved for the skin, since a pass would otherwise never end
  else
    tell(NeedleEventKind::Withdrawn, hole.wall, dot(hole.point - state_.entry_mm, state_.track), events);
  if (!skin) return;
  inside_ = {};
  contacts_ = {};
  onBone_ = {};
  holeCount_ = 0;
  state_.inBody = false;
}

void NeedleMechanics::touch(const TissueGrid& grid, const TissueSample& sample, int wall, Vec3 tip, Vec3 axis,
                            NeedleEvents& events) {
  const bool hard = table_.of(kNeedleWalls[wall]).wall == NeedleWall::Hard;
  Contact& contact = hard ? onBone_ : contacts_[wall];
  const bool across = (sample.distance_mm[wall] < 0) != inside_[wall];
  if (!contact.active) {
    if (across) meet(grid, sample, wall, tip, axis, events);
    return;
  }
  follow(grid, sample, wall, tip, axis);
  const bool behind = dot(tip - contact.point, contact.normal) < -kLetGo_mm || contact.depth_mm < -kLetGo_mm;
  const bool flat = dot(contact.direction, contact.normal) < kRollCosine;
  if (behind || (!across && (contact.slides || flat || hard))) {
    contact.active = false;
    return;
  }
  const NeedleTissue& tissue = table_.of(kNeedleWalls[wall]);
  const Stiffening law{tissue.stiffness_Npmm, tissue.stiffening_Npmm2, 0.6 * steepest_Npmm_};
  contact.force_N = law.force_N(contact.depth_mm);
  if (!hard && !contact.slides && contact.force_N >= tissue.puncture_N) puncture(wall, tip, axis, events);
}

void NeedleMechanics::meet(const TissueGrid& grid, const TissueSample& sample, int wall, Vec3 tip, Vec3 axis,
                           NeedleEvents& events) {
  const bool hard = table_.of(kNeedleWalls[wall]).wall == NeedleWall::Hard;
  Contact& contact = hard ? onBone_ : contacts_[wall];
  const bool inwards = !inside_[wall];
  // The point of contact is the sign change of the distance on the last step; for a wall that was crossed during
  // contact with another, it is the tip.
  const double d0 = sample_.distance_mm[wall], d1 = sample.distance_mm[wall];
  const bool crossed = (d0 < 0) != (d1 < 0);
  const Vec3 point = crossed ? before_ + (tip - before_) * (d0 / (d0 - d1)) : tip;
  const Vec3 outward = grid.outward(point, wall);
  const Vec3 normal = inwards ? -outward : outward;
  const double cosine = dot(axis, normal);
  // Returns on the way back through its own hole, or if no surface is found.
  if (norm(outward) == 0 || cosine < -kSlideCosine) return;
  contact = {.active = true,
             .slides = cosine < kSlideCosine && !hard,
             .inwards = inwards,
             .point = point,
             .direction = cosine < kSlideCosine ? normal : axis,
             .normal = normal,
             .depth_mm = 0,
             .force_N = 0,
             .aside_mm = {}};
  if (hard) tell(NeedleEventKind::Struck, wall, dot(point - state_.entry_mm, state_.track), events);
  follow(grid, sample, wall, tip, axis);
}

void NeedleMechanics::follow(const TissueGrid& grid, const TissueSample& sample, int wall, Vec3 tip, Vec3 axis) {
  const bool hard = table_.of(kNeedleWalls[wall]).wall == NeedleWall::Hard;
  Contact& contact = hard ? onBone_ : contacts_[wall];
  if (contact.slides) {
    // The force depends on the distance alone, so that sliding along a wall conserves energy.
    const Vec3 outward = grid.outward(tip, wall);
    if (norm(outward) > 0) contact.normal = contact.inwards ? -outward : outward;
    contact.depth_mm = contact.inwards ? -sample.distance_mm[wall] : sample.distance_mm[wall];
    contact.direction = contact.normal;
    contact.point = tip - contact.normal * contact.depth_mm;
    if (dot(axis, contact.normal) < kPrickCosine) return;
    contact.slides = false;
    contact.direction = axis;
    contact.point = tip - axis * contact.depth_mm;
  }
  contact.depth_mm = dot(tip - contact.point, contact.direction);
  // The tip drags the wall along until this needs more force than the tip pushes with; then it slips on the surface.
  contact.aside_mm = tip - contact.point - contact.direction * contact.depth_mm;
  const double off_mm = norm(contact.aside_mm), max_mm = std::max(contact.force_N, 0.0) / kAside_Npmm;
  if (hard || off_mm <= max_mm || off_mm < 1e-9) return;
  Vec3 moved = contact.point + contact.aside_mm * (1 - max_mm / off_mm);
  const Vec3 outward = grid.outward(moved, wall);
  moved = moved - outward * grid.at(moved).distance_mm[wall];
  contact.aside_mm = contact.aside_mm * (max_mm / off_mm);
  contact.point = moved;
  if (norm(outward) > 0) contact.normal = contact.inwards ? -outward : outward;
}

void NeedleMechanics::puncture(int wall, Vec3 tip, Vec3 axis, NeedleEvents& events) {
  Contact& contact = contacts_[wall];
  inside_[wall] = contact.inwards;
  contact.active = false;
  if (wall == kSkinWall && contact.inwards) {
    state_.inBody = true;
    state_.entry_mm = contact.point;
    state_.track = axis;
    const double s_mm = dot(tip - contact.point, axis);
    shaft_.restart();
    cut_.restart(s_mm);
    friction_.restart(s_mm);
  }
  if (holeCount_ < static_cast<int>(holes_.size())) holes_[holeCount_++] = {wall, contact.inwards, contact.point};
  tell(contact.inwards ? NeedleEventKind::Entered : NeedleEventKind::Left, wall,
       dot(contact.point - state_.entry_mm, state_.track), events);
}

Label NeedleMechanics::tissueOf(const TissueSample& sample) const {
  if (!inside_[kSkinWall]) return kBackground;
  for (int wall = 1; wall < kNeedleWallCount; ++wall)
    if (inside_[wall]) return kNeedleWalls[wall];
  // The tip pushes tissue ahead until it punctures it; until then the tissue at the tip is that before the wall.
  const Label label = knownLabel(sample.label);
  const NeedleWall wall = table_.of(label).wall;
  return label == kBackground || (wall != NeedleWall::None && label != kSkin) ? around_ : label;
}

void NeedleMechanics::tell(NeedleEventKind kind, int wall, double depth_mm, NeedleEvents& events) {
  events.add(
      {time_ns_, kind, kNeedleWalls[wall], tissueOf(sample_), patientTip_, patientAxis_, depth_mm, state_.depth_mm});
}

}  // namespace insonate::haptics
