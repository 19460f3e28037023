#include "support/NeckScene.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <string>
#include <vector>

namespace insonate::test {
namespace {

using std::numbers::pi;

MechanicalTable measured() {
  return loadMechanicalTable("measured").value();
}

/// Properties of every elastic model, tested through the public interface.
class Physics : public testing::TestWithParam<const char*> {
 protected:
  Deformation solved(double press_mm, double force_N = 0) {
    plane.press_mm = press_mm;
    input.plane = &plane;
    input.force_N = force_N;
    const auto model = makeDeformationModel(GetParam(), table, {.mesh_mm = 1}).value();
    Deformation answer;
    model->solve(input, answer);
    EXPECT_TRUE(answer.converged) << press_mm << " mm " << force_N << " N";
    expectSane(answer);
    return answer;
  }

  static void expectSane(const Deformation& answer) {
    const Folds folds = foldsOf(answer.displacement);
    EXPECT_EQ(folds.notFinite, 0);
    EXPECT_EQ(folds.folded, 0);
  }

  void bloodAsInTheCt() { input.pressure = {table.of(kArtery).pressure_kPa, table.of(kVein).pressure_kPa}; }

  AnalyticPlane plane;
  MechanicalTable table = measured();
  DeformationInput input;
};

TEST_P(Physics, MirroredTissueGivesTheMirroredAnswer) {
  bloodAsInTheCt();
  plane = neckScene();
  const Deformation left = solved(4);
  for (auto& circle : plane.circles) circle.x_mm = -circle.x_mm;
  const Deformation right = solved(4);
  ASSERT_EQ(left.mesh.size(), right.mesh.size());
  double worst = 0;
  for (int j = 0; j < left.meshRows; ++j)
    for (int i = 0; i < left.meshColumns; ++i) {
      const MeshNode& a = left.mesh[std::size_t(j) * left.meshColumns + i];
      const MeshNode& b = right.mesh[std::size_t(j) * left.meshColumns + left.meshColumns - 1 - i];
      worst = std::max({worst, std::abs(double(a.x_mm) + b.x_mm), std::abs(double(a.z_mm) - b.z_mm)});
    }
  RecordProperty("worst_mm", std::to_string(worst));
  EXPECT_LT(worst, 0.02);
  EXPECT_NEAR(left.force_N, right.force_N, 1e-3 * left.force_N);
}

TEST_P(Physics, TheVeinGivesWayMonotonicallyAndBeforeTheArtery) {
  bloodAsInTheCt();
  plane = neckScene();
  double vein = 1.001, artery = 1.001, shift = 0;
  const bool slow = std::string(GetParam()) == "reference";
  for (const double force_N : slow ? std::vector{0.5, 1.0, 1.5} : std::vector{0.25, 0.5, 1.0, 1.5, 2.0, 3.0}) {
    const Deformation answer = solved(0, force_N);
    EXPECT_NEAR(answer.force_N, force_N, 0.01 * force_N);
    EXPECT_GT(answer.faceShift_mm, shift) << force_N;
    EXPECT_LT(areaRatio(answer, kVein), vein) << force_N;
    EXPECT_LT(areaRatio(answer, kArtery), artery) << force_N;
    EXPECT_GT(areaRatio(answer, kArtery), areaRatio(answer, kVein)) << force_N;
    vein = areaRatio(answer, kVein), artery = areaRatio(answer, kArtery), shift = answer.faceShift_mm;
    RecordProperty("vein_" + std::to_string(force_N).substr(0, 4) + "N", std::to_string(vein));
    RecordProperty("artery_" + std::to_string(force_N).substr(0, 4) + "N", std::to_string(artery));
  }
}

/// A line contact (Hertz): half-width a = sqrt(4 P R (1 - nu^2) / (pi E)), far smaller than the layer is deep.
TEST_P(Physics, ARoundFaceTouchesAsWideAsHertzSays) {
  plane.below = kMuscle;
  constexpr double kYoung_kPa = 40, kPoisson = 0.45, kRadius_mm = 60;
  table.tissues[kMuscle].young_kPa = kYoung_kPa;
  table.tissues[kMuscle].poisson = kPoisson;
  input.face.radius_mm = kRadius_mm;
  for (const double force_N : {0.2, 0.5}) {
    const Deformation answer = solved(0, force_N);
    const double load = force_N * 1000 / input.face.footprint_mm;
    const double expected = std::sqrt(4 * load * kRadius_mm * (1 - kPoisson * kPoisson) / (pi * kYoung_kPa));
    // Touching nodes lie in the face by as much as its stiff springs give.
    double half = 0;
    for (int i = 0; i < answer.meshColumns; ++i) {
      const MeshNode& node = answer.mesh[i];
      const double face = std::sqrt(kRadius_mm * kRadius_mm - node.x_mm * node.x_mm) - kRadius_mm + answer.faceShift_mm;
      if (std::abs(node.x_mm) < 15 && node.z_mm < face) half = std::max(half, std::abs(double(node.x_mm)));
    }
    RecordProperty("half_" + std::to_string(force_N).substr(0, 3) + "N", std::to_string(half / expected));
    EXPECT_NEAR(half, expected, 0.75) << force_N;  // nodes are a millimeter or half of it apart
  }
}

/// A wall of 200 kPa and loose tissue in tissue of 10 kPa: layers of a thick cylinder (Lame), the last without end.
/// Skin and bottom are five radii away.
TEST_P(Physics, AVesselWidensAsAThickCylinder) {
  plane.circles = {{0, 20, 4, kArtery}};
  table.tissues[kArtery].pressure_kPa = 0;
  input.pressure.artery_kPa = 0.1;  // small strain
  const MechanicalTissue& artery = table.of(kArtery);
  const double radii[] = {4, 4 + artery.wall_mm, 4 + artery.wall_mm + artery.sheath_mm};
  const double young[] = {artery.wallYoung_kPa, artery.sheathYoung_kPa, table.of(kSoftTissue).young_kPa};
  Eigen::Matrix<double, 6, 6> system = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  const auto tension = [&](int layer, double r) {
    const double mu = young[layer] / (2 * 1.49), lambda = young[layer] * 0.49 / (1.49 * 0.02);
    return Eigen::RowVector2d(2 * (lambda + mu), -2 * mu / (r * r));
  };
  system.block<1, 2>(0, 0) = tension(0, radii[0]);
  right[0] = -input.pressure.artery_kPa;
  for (int layer = 0; layer < 2; ++layer) {
    const double r = radii[layer + 1];
    system.block<1, 4>(1 + 2 * layer, 2 * layer) << r, 1 / r, -r, -1 / r;
    system.block<1, 4>(2 + 2 * layer, 2 * layer) << tension(layer, r), -tension(layer + 1, r);
  }
  system.block<1, 2>(5, 4) << tension(2, 1e4);
  const Eigen::Matrix<double, 6, 1> c = system.partialPivLu().solve(right);
  const double widening = c[0] + c[1] / (radii[0] * radii[0]);
  const Deformation answer = solved(-3);
  const double found = std::sqrt(areaRatio(answer, kArtery)) - 1;
  RecordProperty("per_exact", std::to_string(found / widening));
  EXPECT_NEAR(found / widening, 1, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Models, Physics, testing::Values("elastic", "reference"),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
}  // namespace insonate::test
