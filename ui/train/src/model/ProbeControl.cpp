#include "ProbeControl.h"

#include <insonate/simulator/ProbePose.h>

#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

constexpr std::string_view kNoHand = "The patient's skin is not known yet.";

/// From -180 up to 180.
double turned_deg(double degrees) {
  return std::remainder(degrees, 360);
}

}  // namespace

HandNumbers numbersOf(const ProbePlacementState& state) {
  return {state.skin_mm, rotationOf_deg(state), state.tilt_deg, state.rock_deg, state.press_mm};
}

double HandNumbers::of(HandAxis axis) const {
  switch (axis) {
    case HandAxis::Rotation:
      return rotation_deg;
    case HandAxis::Tilt:
      return tilt_deg;
    case HandAxis::Rock:
      return rock_deg;
    case HandAxis::Press:
      return press_mm;
    default:
      return 0;
  }
}

void ProbeControl::setHand(std::optional<ProbePlacement> hand) {
  hand_ = std::move(hand);
  gestureOpen_ = false;
}

template <class Move>
MoveResult ProbeControl::done(const Move& move) {
  if (!hand_) return {kNoHand};
  const ProbePlacementState before = hand_->state();
  const MoveResult result = move(*hand_);
  if (hand_->state() == before) return result;
  if (!std::exchange(gestureOpen_, true) && gestureBegan_) gestureBegan_(before);
  return result;
}

MoveResult ProbeControl::move(HandAxis axis, double amount) {
  return done([&](ProbePlacement& hand) {
    switch (axis) {
      case HandAxis::Lateral:
        return hand.slide(amount, 0);
      case HandAxis::Elevation:
        return hand.slide(0, amount);
      case HandAxis::Rotation:
        return hand.rotate(amount);
      case HandAxis::Tilt:
        return hand.tilt(amount);
      case HandAxis::Rock:
        return hand.rock(amount);
      case HandAxis::Press:
        return hand.press(amount);
    }
    return MoveResult{};
  });
}

MoveResult ProbeControl::slide(double lateral_mm, double elevation_mm) {
  return done([&](ProbePlacement& hand) { return hand.slide(lateral_mm, elevation_mm); });
}

MoveResult ProbeControl::set(HandAxis axis, double value) {
  const double change = value - numbers().of(axis);
  return move(axis, axis == HandAxis::Rotation ? turned_deg(change) : change);
}

MoveResult ProbeControl::moveTo(Vec3 patient_mm) {
  return done([&](ProbePlacement& hand) { return hand.moveTo(patient_mm); });
}

MoveResult ProbeControl::setPose(const StartPose& pose) {
  const auto transform = patientFromProbe(pose.position_mm, pose.axial, pose.lateral);
  if (!transform) return {"This position is not a pose of a probe."};
  return done([&](ProbePlacement& hand) { return hand.setPose(*transform); });
}

MoveResult ProbeControl::setPose(const ProbePlacementState& state) {
  return done([&](ProbePlacement& hand) {
    hand.restore(state);
    return MoveResult{};
  });
}

void ProbeControl::follow(const Transform& patientFromProbe) {
  if (hand_) hand_->setPose(patientFromProbe);
}

void ProbeControl::restore(const ProbePlacementState& state) {
  if (hand_) hand_->restore(state);
  gestureOpen_ = false;
}

}  // namespace insonate::train
