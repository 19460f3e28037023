#include "support/Allocations.h"
#include "support/AnalyticPlane.h"

#include <insonate/deformation/DeformationModel.h>

#include <gmock/gmock.h>

#include <cmath>

namespace insonate {
namespace {

using test::AnalyticPlane;

/// Skin, fat and muscle over a vertebra, a vein of 12 mm and an artery of 7 mm beside each other.
AnalyticPlane neck() {
  AnalyticPlane plane;
  plane.layers = {{1.5, kSkin}, {3, kFat}};
  plane.circles = {{-7, 13, 6, kVein}, {8, 15, 3.5, kArtery}};
  plane.blocks = {{-60, 38, 60, 80, kBone}};
  return plane;
}

class Elastic : public testing::Test {
 protected:
  Elastic() {
    input_.plane = &plane_;
    input_.pressure = {table_.of(kArtery).pressure_kPa, table_.of(kVein).pressure_kPa};
  }

  const Deformation& pressed(double indent_mm) {
    plane_.press_mm = indent_mm;
    input_.patientFromProbe = plane_.patientFromProbe();
    // A vein that is about to shut may need longer than one question's steps.
    for (int k = 0; k == 0 || (k < 4 && !answer_.converged); ++k) model_->solve(input_, answer_);
    return answer_;
  }
  static double ratio(const Deformation& d, std::uint8_t label) {
    for (const LumenArea& l : d.lumens)
      if (l.label == label) return l.area_mm2 / l.rest_mm2;
    return -1;
  }

  AnalyticPlane plane_ = neck();
  MechanicalTable table_ = loadMechanicalTable("measured").value();
  std::unique_ptr<DeformationModel> model_ = makeDeformationModel("elastic", table_).value();
  DeformationInput input_;
  Deformation answer_;
};

TEST_F(Elastic, DoesNothingWithoutContact) {
  EXPECT_FALSE(pressed(0).moved);
  EXPECT_TRUE(answer_.displacement.empty());
  EXPECT_EQ(answer_.force_N, 0);
}

TEST_F(Elastic, FlattensTheVeinBeforeTheArtery) {
  double vein = 1.01, force = -1;
  for (const double indent_mm : {1.0, 2.0, 4.0, 6.0}) {
    const Deformation& d = pressed(indent_mm);
    EXPECT_TRUE(d.converged) << indent_mm;
    EXPECT_LT(ratio(d, kVein), vein) << indent_mm;
    EXPECT_GT(d.force_N, force) << indent_mm;
    EXPECT_GT(ratio(d, kArtery), ratio(d, kVein)) << indent_mm;
    vein = ratio(d, kVein), force = d.force_N;
  }
  EXPECT_LT(vein, 0.4);
}

TEST_F(Elastic, KeepsTheSkinUnderTheFaceOnIt) {
  const Deformation& d = pressed(5);
  for (int i = 0; i < d.meshColumns; ++i)
    if (std::abs(d.mesh[i].x_mm) < 17) {
      EXPECT_NEAR(d.mesh[i].z_mm, 0, 0.05) << d.mesh[i].x_mm;
    }
}

TEST_F(Elastic, ReleaseRestoresTheFirstPicture) {
  EXPECT_TRUE(pressed(6).moved);
  pressed(0);
  EXPECT_FALSE(answer_.moved);
  EXPECT_TRUE(answer_.displacement.empty());
}

TEST_F(Elastic, AllocatesNothingWhileAPressingProbeKeepsItsMesh) {
  const auto frame = [&](int k) {
    plane_.press_mm = 3 + 0.1 * (k % 3);
    plane_.slide_mm = 0.05 * (k % 4);
    input_.patientFromProbe = plane_.patientFromProbe();
    model_->solve(input_, answer_);
  };
  for (int k = 0; k < 24; ++k) frame(k);
  const long before = test::allocations();
  for (int k = 0; k < 24; ++k) frame(k);
  EXPECT_EQ(test::allocations() - before, 0);
}

TEST_F(Elastic, AskedAgainItGivesTheSame) {
  pressed(4);
  const Deformation first = answer_;
  model_->solve(input_, answer_);
  EXPECT_TRUE(answer_.converged);
  EXPECT_LE(answer_.iterations, 4);
  EXPECT_NEAR(answer_.force_N, first.force_N, 0.01 * first.force_N);
  EXPECT_NEAR(ratio(answer_, kVein), ratio(first, kVein), 0.003);
}

TEST_F(Elastic, WhereTheVesselsHaveGoneBloodDoesNothing) {
  input_.pressure.vein_kPa += 0.6;
  EXPECT_TRUE(pressed(0).moved);
  plane_.circles.clear();
  plane_.slide_mm = 1;
  EXPECT_FALSE(pressed(0).moved);
}

TEST_F(Elastic, FindsTheShiftForAForce) {
  input_.force_N = 1.5;
  const Deformation d = pressed(0);
  EXPECT_NEAR(d.force_N, 1.5, 0.02);
  input_.force_N = 0;
  EXPECT_NEAR(pressed(d.faceShift_mm).force_N, 1.5, 0.06);
}

TEST_F(Elastic, AFullerVeinIsWider) {
  input_.pressure.vein_kPa += 0.6;
  const Deformation& d = pressed(0);
  EXPECT_TRUE(d.moved);
  EXPECT_GT(ratio(d, kVein), 1.1);
  EXPECT_NEAR(ratio(d, kArtery), 1, 0.03);
}

}  // namespace
}  // namespace insonate
