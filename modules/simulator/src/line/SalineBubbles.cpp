#include "line/SalineBubbles.h"

#include <insonate/core/Hash.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace insonate {
namespace {

/// So many that a short axis of a vein with a velocity of 15 cm/s shows about ten; our choice.
constexpr int kDrops = 1500;
constexpr double kStep_s = 0.02;
/// The bubbles leave the tip within this distance of it along the vessel, and fill this part of its radius.
constexpr double kJet_mm = 2, kFilled = 0.9;
/// Echo of a bubble relative to speckle, its decay as the bubbles dissolve, and the end of the last ones; our choice,
/// by which a flush is seen for about five seconds.
constexpr double kEcho = 12, kDecay_s = 2, kEnd_s = 0.7;
/// Largest distance from the end of a vessel to the center line of the next, relative to the radius of the next.
constexpr double kJoins_radii = 1.5;

/// Number of the segment of a center line, and the share of it that is passed.
std::pair<std::size_t, double> bloodSegmentAt(const BloodTube& tube, double along) {
  const std::size_t last = tube.course.size() < 2 ? 0 : tube.course.size() - 2;
  const std::size_t segment = std::min(static_cast<std::size_t>(std::max(along, 0.0)), last);
  return {segment, along - static_cast<double>(segment)};
}

const BloodTube::Point& pointOf(const BloodTube& tube, std::size_t index) {
  return tube.course[std::min(index, tube.course.size() - 1)];
}

/// Tells whether blood flows from the first to the last point of the center line.
bool flowsForward(const BloodTube& tube) {
  for (std::size_t i = 0; i + 1 < tube.course.size(); ++i) {
    const double along = dot(tube.course[i].direction, tube.course[i + 1].position_mm - tube.course[i].position_mm);
    if (along != 0) return along > 0;
  }
  return true;
}

/// Place on the center line nearest to a point, and its distance relative to the radius there.
std::pair<double, double> nearestInTube(const BloodTube& tube, Vec3 patient_mm) {
  double along = 0, least_radii = HUGE_VAL;
  for (std::size_t s = 0; s + 1 < std::max<std::size_t>(tube.course.size(), 2); ++s) {
    const BloodTube::Point &a = pointOf(tube, s), &b = pointOf(tube, s + 1);
    const Vec3 way = b.position_mm - a.position_mm;
    const double length2 = dot(way, way);
    const double share = length2 > 0 ? std::clamp(dot(patient_mm - a.position_mm, way) / length2, 0.0, 1.0) : 0;
    const double off_mm = norm(patient_mm - a.position_mm - way * share);
    const double radii = off_mm / (a.radius_mm + share * (b.radius_mm - a.radius_mm));
    if (radii < least_radii) least_radii = radii, along = static_cast<double>(s) + share;
  }
  return {along, least_radii};
}

}  // namespace

SalineBubbles::SalineBubbles(std::span<const NamedVessel> vessels, const LabelMap* labels)
    : model_(vessels), labels_(labels) {
  if (labels) indexFromPatient_ = inverted(labels->geometry.patientFromIndex());
}

void SalineBubbles::release() {
  const SalineFlush& flush = case_->flush;
  model_.at(case_->physiology, std::nullopt, {}, flow_);
  const auto place = placeInTubes(flow_, flush.wall, flush.from_mm);
  const int tube = place ? static_cast<int>(place->tube - flow_.tubes.data()) : -1;
  const auto seed = static_cast<std::uint32_t>(std::llround(flush.time_s * 1e6));
  drops_.assign(kDrops, {});
  steps_ = 0;
  for (int i = 0; i < kDrops; ++i) {
    const auto uniform = [&](int of) { return unitInterval(hashNode(i, of, 0, seed)); };
    Drop& drop = drops_[i];
    drop.release_s = kInjection_s * (i + uniform(0)) / kDrops;
    drop.amplitude = kEcho * (0.4 + uniform(1));
    drop.fromCenter = kFilled * std::sqrt(uniform(2)), drop.around = 2 * std::numbers::pi * uniform(3);
    drop.beside_mm = (Vec3{uniform(4), uniform(5), uniform(6)} - Vec3{0.5, 0.5, 0.5}) * (2 * kJet_mm);
    drop.tube = tube;
    if (!place) continue;
    drop.along = place->segment + place->along;
    move(drop, drop.beside_mm.x);
  }
}

double SalineBubbles::speed_mmps(const Drop& drop) const {
  const BloodTube& tube = flow_.tubes[drop.tube];
  const auto [segment, share] = bloodSegmentAt(tube, drop.along);
  const double before = pointOf(tube, segment).scale, after = pointOf(tube, segment + 1).scale;
  return (before + share * (after - before)) * tube.profileAt_mmps(drop.fromCenter);
}

/// Goes on from the end of a vessel into the vessel that it joins, or out of the case.
void SalineBubbles::goOn(Drop& drop) const {
  const BloodTube& left = flow_.tubes[drop.tube];
  const Vec3 end_mm = pointOf(left, static_cast<std::size_t>(std::lround(drop.along))).position_mm;
  double least_radii = kJoins_radii;
  int next = -1;
  for (std::size_t t = 0; t < flow_.tubes.size(); ++t) {
    const BloodTube& tube = flow_.tubes[t];
    if (&tube == &left || tube.label != left.label) continue;
    const auto [along, radii] = nearestInTube(tube, end_mm);
    const bool isAtEnd = flowsForward(tube) ? along >= static_cast<double>(tube.course.size() - 1) : along <= 0;
    if (isAtEnd || radii >= least_radii) continue;
    least_radii = radii, next = static_cast<int>(t), drop.along = along;
  }
  drop.tube = next >= 0 ? next : drop.tube, drop.isGone = next < 0;
}

/// `by_mm`: along the flow; negative against it. Against the flow, a vessel ends with its center line.
void SalineBubbles::move(Drop& drop, double by_mm) const {
  constexpr int kMaxSegments = 200;
  for (int passed = 0; passed < kMaxSegments && by_mm != 0 && !drop.isGone; ++passed) {
    const BloodTube& tube = flow_.tubes[drop.tube];
    if (tube.course.size() < 2) return;
    const bool isUp = flowsForward(tube) == (by_mm > 0);
    auto [segment, share] = bloodSegmentAt(tube, drop.along);
    if (!isUp && share == 0 && segment > 0) --segment, share = 1;
    const double length_mm = norm(tube.course[segment + 1].position_mm - tube.course[segment].position_mm);
    const double room_mm = length_mm * (isUp ? 1 - share : share);
    if (std::abs(by_mm) < room_mm) {
      drop.along = static_cast<double>(segment) + share + (isUp ? 1 : -1) * std::abs(by_mm) / length_mm;
      return;
    }
    const std::size_t reached = isUp ? segment + 1 : segment;
    drop.along = static_cast<double>(reached);
    const bool isEnd = reached == (isUp ? tube.course.size() - 1 : 0);
    if (isEnd && by_mm < 0) return;
    by_mm -= std::copysign(room_mm, by_mm);
    if (isEnd) goOn(drop);
  }
}

void SalineBubbles::advance(double from_s, double to_s) {
  const auto time_s = case_->bloodTime_s ? std::optional(*case_->bloodTime_s + from_s) : std::nullopt;
  model_.at(case_->physiology, time_s, {}, flow_);
  for (Drop& drop : shown_) {
    const double seconds = to_s - std::max(from_s, drop.release_s);
    if (seconds > 0 && drop.tube >= 0 && !drop.isGone) move(drop, speed_mmps(drop) * seconds);
  }
}

Vec3 SalineBubbles::positionOf(const Drop& drop) const {
  if (drop.tube < 0) return case_->flush.from_mm + drop.beside_mm;
  const BloodTube& tube = flow_.tubes[drop.tube];
  const auto [segment, share] = bloodSegmentAt(tube, drop.along);
  const BloodTube::Point &a = pointOf(tube, segment), &b = pointOf(tube, segment + 1);
  const double radius_mm = a.radius_mm + share * (b.radius_mm - a.radius_mm);
  const Vec3 center_mm = a.position_mm + (b.position_mm - a.position_mm) * share;
  const Vec3 direction = a.direction + (b.direction - a.direction) * share;
  if (!(norm(direction) > 0)) return center_mm;
  // One direction for the whole tube, so that a bubble does not jump around the center line.
  const Vec3 whole = tube.course.back().position_mm - tube.course.front().position_mm;
  const Vec3 aside = std::abs(whole.x) < 0.7 * norm(whole) ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 across = cross(direction, aside);
  const Vec3 u = normalized(norm(across) > 1e-3 ? across : cross(direction, Vec3{0, 1, 0}));
  const Vec3 v = normalized(cross(direction, u));
  return center_mm + (u * std::cos(drop.around) + v * std::sin(drop.around)) * (radius_mm * drop.fromCenter);
}

void SalineBubbles::show(double age_s) {
  bubbles_.clear();
  const double end = std::clamp((kLife_s - age_s) / kEnd_s, 0.0, 1.0);
  for (const Drop& drop : shown_) {
    if (drop.isGone || drop.release_s > age_s) continue;
    const Vec3 at_mm = positionOf(drop);
    if (labels_ && sampleNearest(*labels_, indexFromPatient_ * at_mm) != case_->flush.wall) continue;
    bubbles_.push_back({at_mm, drop.amplitude * end * std::exp(-(age_s - drop.release_s) / kDecay_s)});
  }
}

std::span<const Bubble> SalineBubbles::at(const SalineFlush& flush, double age_s, const Physiology& physiology,
                                          std::optional<double> bloodTime_s) {
  if (!(age_s >= 0) || age_s >= kLife_s) return {};
  const Case now{flush, physiology, bloodTime_s};
  const int steps = static_cast<int>(age_s / kStep_s);
  if (case_ != now || steps < steps_) {
    case_ = now;
    release();
  }
  shown_ = drops_;
  for (; steps_ < steps; ++steps_) advance(steps_ * kStep_s, (steps_ + 1) * kStep_s);
  drops_ = shown_;
  advance(steps_ * kStep_s, age_s);
  show(age_s);
  return bubbles_;
}

}  // namespace insonate
