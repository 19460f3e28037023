#include "model/ProbeControl.h"

#include <insonate/simulator/ProbePose.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <cmath>
#include <vector>

namespace insonate::train {
namespace {

ProbeControl controlOverSmallCase() {
  static const PatientCase patient = test::smallCase();
  ProbeControl control;
  auto hand = ProbePlacement::make(patient.labels, *patientFromProbe({0, 0, 0}, {0, 1, 0}, {1, 0, 0}));
  EXPECT_TRUE(hand) << hand.error().message;
  control.setHand(std::move(*hand));
  return control;
}

TEST(ProbeControl, NothingMovesWithoutAHand) {
  ProbeControl control;
  EXPECT_FALSE(control.ready());
  EXPECT_FALSE(control.move(HandAxis::Tilt, 5).done());
}

TEST(ProbeControl, RotationIsZeroAcrossTheBody) {
  // On the front of the body, the marker to the patient's left; a quarter turn from lateral toward elevation, which is
  // toward the feet there.
  ProbePlacementState state{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  EXPECT_NEAR(numbersOf(state).rotation_deg, 0, 1e-9);
  state.lateral = {0, 0, -1};
  EXPECT_NEAR(numbersOf(state).rotation_deg, 90, 1e-9);
  // On the patient's right side, across is toward the front.
  state = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}};
  EXPECT_NEAR(numbersOf(state).rotation_deg, 0, 1e-9);
  // On top of the head there is no across: the patient's left stands in.
  state = {{0, 0, 0}, {0, 0, -1}, {1, 0, 0}};
  EXPECT_NEAR(numbersOf(state).rotation_deg, 0, 1e-9);
}

TEST(ProbeControl, TypedNumbersAreReached) {
  ProbeControl control = controlOverSmallCase();
  for (const HandAxis axis : {HandAxis::Rotation, HandAxis::Tilt, HandAxis::Rock}) {
    EXPECT_TRUE(control.set(axis, 20).done());
    EXPECT_NEAR(control.numbers().of(axis), 20, 1e-6);
    control.begin();
  }
  EXPECT_TRUE(control.set(HandAxis::Press, 3).done());
  EXPECT_NEAR(control.numbers().press_mm, 3, 1e-6);
}

TEST(ProbeControl, RotationTakesTheShortWay) {
  ProbeControl control = controlOverSmallCase();
  control.set(HandAxis::Rotation, 170);
  control.set(HandAxis::Rotation, -170);
  EXPECT_NEAR(control.numbers().rotation_deg, -170, 1e-6);
}

TEST(ProbeControl, AGestureIsToldOnce) {
  ProbeControl control = controlOverSmallCase();
  std::vector<ProbePlacementState> told;
  control.setGestureBegan([&](const ProbePlacementState& before) { told.push_back(before); });
  const ProbePlacementState start = control.hand()->state();
  control.begin();
  control.slide(2, 0);
  control.slide(2, 1);
  const ProbePlacementState between = control.hand()->state();
  control.begin();
  control.move(HandAxis::Tilt, 10);
  EXPECT_EQ(told, (std::vector{start, between}));
  control.restore(start);
  EXPECT_EQ(control.hand()->state(), start);
  EXPECT_EQ(told.size(), 2u) << "to put it back is no gesture";
}

TEST(ProbeControl, AMoveThatDidNothingIsNotTold) {
  ProbeControl control = controlOverSmallCase();
  bool told = false;
  control.setGestureBegan([&](const ProbePlacementState&) { told = true; });
  control.begin();
  control.slide(0, 0);
  EXPECT_FALSE(told);
}

}  // namespace
}  // namespace insonate::train
