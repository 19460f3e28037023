#include "ColumnRig.h"

#include <gmock/gmock.h>

#include <functional>
#include <random>

namespace insonate::test {
namespace {

/// Whatever was asked: finite numbers, sizes that agree, tissue that is nowhere turned over.
void expectSane(const Deformation& answer) {
  EXPECT_TRUE(std::isfinite(answer.force_N) && std::isfinite(answer.faceShift_mm));
  const PlaneDisplacement& d = answer.displacement;
  ASSERT_EQ(d.restFromDisplayed.size(), std::size_t(d.columns) * d.rows);
  ASSERT_EQ(answer.mesh.size(), std::size_t(answer.meshColumns) * answer.meshRows);
  EXPECT_EQ(answer.moved, !d.empty());
  int wrong = 0;
  for (int c = 0; c < d.columns; ++c)
    for (int r = 0; r < d.rows; ++r) {
      const std::size_t i = std::size_t(r) * d.columns + c;
      wrong += !std::isfinite(d.restFromDisplayed[i].z_mm) || d.restFromDisplayed[i].x_mm != 0;
      wrong += r > 0 && !(d.step_mm + d.restFromDisplayed[i].z_mm - d.restFromDisplayed[i - d.columns].z_mm > 0);
      wrong += r > 0 && !(answer.mesh[i].z_mm > answer.mesh[i - d.columns].z_mm);
    }
  for (const float pressure : answer.pressure_kPa) wrong += !(pressure >= 0) || std::isinf(pressure);
  for (const LumenArea& lumen : answer.lumens) wrong += !(lumen.area_mm2 >= 0 && lumen.area_mm2 <= lumen.rest_mm2);
  EXPECT_EQ(wrong, 0);
}

/// Any tissue, also what cannot be.
class MadePlane : public TissuePlane {
 public:
  std::function<PlaneTissue(PlanePoint)> made;
  void sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const override {
    for (std::size_t i = 0; i < at.size(); ++i) tissue[i] = made(at[i]);
  }
};

class ColumnHardInput : public ColumnRig {
 protected:
  Deformation solvedOn(std::function<PlaneTissue(PlanePoint)> made, double force_N = 0) {
    MadePlane odd;
    odd.made = std::move(made);
    DeformationInput input;
    input.plane = &odd;
    input.face = face;
    input.force_N = force_N;
    Deformation answer;
    (*makeDeformationModel("column", tissues, settings))->solve(input, answer);
    return answer;
  }
};

TEST_F(ColumnHardInput, WithoutContactNothingMoves) {
  plane.press_mm = -2;
  for (const double force_N : {0.0, -1.0, std::nan("")}) {
    const Deformation answer = solved(force_N);
    EXPECT_FALSE(answer.moved);
    EXPECT_TRUE(answer.converged);
    EXPECT_EQ(answer.force_N, 0);
    EXPECT_TRUE(answer.displacement.empty());
    EXPECT_TRUE(answer.mesh.empty());
  }
}

TEST_F(ColumnHardInput, AFaceThatJustTouchesMovesNothing) {
  plane.press_mm = 0;
  EXPECT_FALSE(solved().moved);
}

TEST_F(ColumnHardInput, NoPlaneAndNoBodyMoveNothing) {
  Deformation answer;
  (*makeDeformationModel("column", tissues))->solve({}, answer);
  EXPECT_FALSE(answer.moved);
  for (const double force_N : {0.0, 5.0}) {
    EXPECT_FALSE(solvedOn([](PlanePoint) { return PlaneTissue{0, 6, 6, 6, 6}; }, force_N).moved);
    EXPECT_FALSE(solvedOn([](PlanePoint) { return PlaneTissue{0, 6, 6, 6, std::nanf("")}; }, force_N).moved);
  }
}

TEST_F(ColumnHardInput, DeepInsideTheBodyTheAnswerSaysThatItIsNone) {
  for (const double force_N : {0.0, 5.0}) {
    const Deformation answer = solvedOn([](PlanePoint) { return PlaneTissue{kMuscle, 6, 6, 6, -6}; }, force_N);
    EXPECT_FALSE(answer.moved);
    EXPECT_FALSE(answer.converged);
    expectSane(answer);
  }
}

TEST_F(ColumnHardInput, UnknownLabelsAreSoftTissue) {
  plane.press_mm = 4;
  const Deformation soft = solved();
  plane.below = 200;
  const Deformation unknown = solved();
  expectSane(unknown);
  EXPECT_EQ(unknown.force_N, soft.force_N);
}

TEST_F(ColumnHardInput, ASoftLayerIsNotPressedToNothing) {
  tissues.tissues[kFat].young_kPa = 0.1;
  plane.layers = {{5, kSkin}, {4, kFat}, {100, kMuscle}};
  plane.press_mm = 9;
  const Deformation answer = solved();
  expectSane(answer);
  EXPECT_TRUE(answer.converged);  // the others gave what the fat could not
  EXPECT_NEAR(forward(answer, middle(answer), 0) - forward(answer, middle(answer), -4), 0.4, 1e-4);
  EXPECT_NEAR(forward(answer, middle(answer), -9), 0, 1e-4);
}

TEST_F(ColumnHardInput, NoForcePressesThroughBone) {
  plane.layers = {{6, kSoftTissue}, {100, kBone}};
  for (const double force_N : {1.0, 100.0, 1e9}) {
    const Deformation answer = solved(force_N);
    expectSane(answer);
    EXPECT_LE(answer.faceShift_mm, 5.4 + 1e-9);
  }
  EXPECT_FALSE(solved(1e9).converged);
  plane.press_mm = 8;
  EXPECT_FALSE(solved().converged);
}

TEST_F(ColumnHardInput, TheEdgeOfTheBodyDoesNotTearTheField) {
  plane.press_mm = 5;
  plane.rightEnd_mm = 4;
  const Deformation answer = solved();
  expectSane(answer);
  const int outside = middle(answer) + 20, row = rowAt(answer, 10);
  EXPECT_NEAR(restOf(answer, outside, row), restOf(answer, middle(answer) + 7, row), 1e-5);
  plane.rightEnd_mm = -4;  // nothing under the face's middle
  EXPECT_FALSE(solved().moved);
}

TEST_F(ColumnHardInput, OddFacesAreTakenAsTheNearestSaneOne) {
  plane.press_mm = 3;
  for (const double width_mm : {0.0, -5.0, 1e9, std::nan(""), kInfinite}) {
    face.width_mm = face.footprint_mm = width_mm;
    expectSane(solved());
    expectSane(solved(2));
  }
}

TEST_F(ColumnHardInput, RandomTissueAndMoves) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  settings.mesh_mm = 1;
  for (int i = 0; i < 200; ++i) {
    for (MechanicalTissue& tissue : tissues.tissues)
      tissue.young_kPa = uniform(0, 1) < 0.1 ? kInfinite : std::pow(10, uniform(-2, 5));
    plane.press_mm = uniform(-5, 29);
    plane.slide_mm = uniform(-30, 30);
    plane.skinRadius_mm = uniform(0, 1) < 0.5 ? 0 : uniform(20, 90);
    plane.layers = {{uniform(0, 5), kSkin}, {uniform(0, 15), kFat}};
    plane.circles = {{uniform(-20, 20), uniform(0, 40), uniform(0.2, 12), kVein}};
    plane.blocks = {{uniform(-40, 0), uniform(0, 20), uniform(0, 40), uniform(20, 60), kBone}};
    expectSane(solved(uniform(0, 1) < 0.5 ? 0 : std::pow(10, uniform(-3, 4))));
  }
}

TEST_F(ColumnHardInput, NoiseForTissue) {
  std::mt19937 random(3);
  for (int i = 0; i < 5; ++i)
    expectSane(solvedOn(
        [&](PlanePoint) {
          return PlaneTissue{static_cast<std::uint8_t>(random() % 256), 6, 6, 6, float(random() % 3) - 1};
        },
        i % 2 ? 3 : 0));
}

}  // namespace
}  // namespace insonate::test
