#include "support/Allocations.h"
#include "support/NeckScene.h"

#include <insonate/deformation/DeformationModel.h>

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace insonate {
namespace {

using test::AnalyticPlane;
using test::areaRatio;
using test::neckScene;

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

  AnalyticPlane plane_ = neckScene();
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
    EXPECT_LT(areaRatio(d, kVein), vein) << indent_mm;
    EXPECT_GT(d.force_N, force) << indent_mm;
    EXPECT_GT(areaRatio(d, kArtery), areaRatio(d, kVein)) << indent_mm;
    vein = areaRatio(d, kVein), force = d.force_N;
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
  EXPECT_NEAR(areaRatio(answer_, kVein), areaRatio(first, kVein), 0.003);
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
  EXPECT_GT(areaRatio(d, kVein), 1.1);
  EXPECT_NEAR(areaRatio(d, kArtery), 1, 0.03);
}

/// A probe that slides and goes in from image to picture.
class ElasticOnTheWay : public testing::Test {
 protected:
  struct Way {
    std::vector<Deformation> pictures;
    int steps = 0;
  };
  static Way go(double movingTolerance_mm, int pictures) {
    const MechanicalTable table = loadMechanicalTable("measured").value();
    const auto model = makeDeformationModel("elastic", table, {.movingTolerance_mm = movingTolerance_mm}).value();
    AnalyticPlane plane = neckScene();
    DeformationInput input;
    input.plane = &plane;
    input.pressure = {table.of(kArtery).pressure_kPa, table.of(kVein).pressure_kPa};
    Way way;
    for (int k = 0; k < pictures; ++k) {
      plane.press_mm = 0.25 * (k + 1);
      plane.slide_mm = 0.3 * k;
      input.patientFromProbe = plane.patientFromProbe();
      model->solve(input, way.pictures.emplace_back());
      way.steps += way.pictures.back().iterations;
    }
    return way;
  }
};

TEST_F(ElasticOnTheWay, ComesToRestInFewSteps) {
  const Way exact = go(0, 9);
  for (const Deformation& picture : exact.pictures) EXPECT_TRUE(picture.converged);
  EXPECT_LE(exact.steps, 45);
}

TEST_F(ElasticOnTheWay, OneStepAPictureIsNearThat) {
  const Way quick = go(0.5, 12), exact = go(0, 12);
  EXPECT_LE(quick.steps, 18);
  for (std::size_t k = 0; k < quick.pictures.size(); ++k) {
    const Deformation &a = quick.pictures[k], &b = exact.pictures[k];
    AnalyticPlane tissue = neckScene();
    const double press_mm = 0.25 * double(k + 1), slide_mm = 0.3 * double(k);
    const auto counts = [&](const MeshNode& n) {
      const std::uint8_t label = tissue.of(n.restX_mm + slide_mm, n.restZ_mm + press_mm).label;
      return std::abs(n.restX_mm) < 20 && n.restZ_mm < 30 && label != kVein && label != kArtery && label != kBackground;
    };
    EXPECT_LT(test::nodeDifference(a, b, counts).rms_mm, 0.05) << k;
    EXPECT_NEAR(a.force_N, b.force_N, 0.03) << k;
    EXPECT_NEAR(areaRatio(a, kVein), areaRatio(b, kVein), 0.012) << k;
  }
}

TEST_F(Elastic, AForceIsFoundInFewSteps) {
  for (const auto& [force_N, steps] : {std::pair{0.5, 8}, {1.0, 18}}) {
    model_->reset();
    input_.force_N = force_N;
    EXPECT_TRUE(pressed(0).converged) << force_N;
    EXPECT_NEAR(answer_.force_N, force_N, 0.01) << force_N;
    EXPECT_LE(answer_.iterations, steps) << force_N;
  }
}

/// Under soft tissue that bulges over rigid tissue, the air between them is squeezed to nothing.
TEST_F(Elastic, AirThatIsSqueezedShutStopsNothing) {
  plane_ = {};
  plane_.leftEnd_mm = -30;
  plane_.rightEnd_mm = 30;
  plane_.blocks = {{-100, 40, 100, 100, kBone}};
  for (int press_mm = 1; press_mm <= 10; ++press_mm) {
    pressed(press_mm);
    EXPECT_TRUE(answer_.converged) << press_mm;
  }
  const double force_N = answer_.force_N;
  pressed(10);
  EXPECT_NEAR(answer_.force_N, force_N, 0.03 * force_N);
}

}  // namespace
}  // namespace insonate
