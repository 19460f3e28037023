#include "elastic/Solver.h"
#include "reference/Equilibrium.h"
#include "support/NeckScene.h"

#include <gtest/gtest.h>

#include <string>

namespace insonate::test {
namespace {

/// A neck under the face, on a mesh of 1 mm.
class Balance : public testing::Test {
 protected:
  Balance() {
    plane.press_mm = kPress_mm;
    mesh.build(plane, face, {.mesh_mm = 1});
    materials.fill(mesh, plane, table);
  }

  static constexpr double kPress_mm = 6;
  AnalyticPlane plane = neckScene();
  MechanicalTable table = loadMechanicalTable("measured").value();
  BloodPressure blood{table.of(kArtery).pressure_kPa, table.of(kVein).pressure_kPa};
  ProbeFace face;
  const FaceProfile profile{face};
  elastic::Mesh mesh;
  elastic::Materials materials;
};

TEST_F(Balance, WorkOfTheFaceIsStoredInTheTissue) {
  const reference::Body body = reference::makeBody(mesh, materials, blood);
  reference::Equilibrium equilibrium(body);
  reference::Load load{.blood = blood, .face = &profile, .shift_mm = -kPress_mm};
  load.meeting = body.rest;
  const double before = energyOf(body, body.rest, load);
  double work = 0, force = 0;
  for (int step = 1; step <= 24; ++step) {
    load.shift_mm = -kPress_mm * (1 - step / 24.0);
    ASSERT_TRUE(equilibrium.solve(load, 0, 1e-6, 60).converged);
    const double now = faceForceOf(body, equilibrium.state.at, load);
    work += (force + now) / 2 * kPress_mm / 24;
    force = now;
  }
  const double stored = energyOf(body, equilibrium.state.at, load) - before;  // less what blood gave
  RecordProperty("work_per_stored", std::to_string(work / stored));
  EXPECT_NEAR(work / stored, 1, 0.03);
}

TEST_F(Balance, TheFacePressesWithWhatTheBottomHolds) {
  elastic::Solver solver;
  solver.prepare(mesh, materials, table);
  solver.setPressure(blood);
  const auto outcome = solver.solve(profile, {}, {.maxIterations = 100, .tolerance_mm = 1e-3f});
  ASSERT_TRUE(outcome.converged);
  elastic::GridMatrix matrix;
  matrix.resize(mesh.columns(), mesh.rows());
  std::vector<float> force(2 * materials.fixed.size() + 2 * elastic::GridMatrix::kPadding);
  assemble(solver.elements(), solver.at(), false, matrix, force);
  const elastic::Nodes& rest = mesh.rest();
  std::vector<float> atRest(force.size());
  assemble(solver.elements(), rest, false, matrix, atRest);
  double down = 0, across = 0;
  for (std::size_t n = 0; n < materials.fixed.size(); ++n)
    if (materials.fixed[n]) {
      across += force[2 * n] - atRest[2 * n];
      down += force[2 * n + 1] - atRest[2 * n + 1];
    }
  EXPECT_NEAR(down, outcome.force_kPa_mm, 0.005 * outcome.force_kPa_mm);
  EXPECT_NEAR(across, 0, 0.005 * outcome.force_kPa_mm);
}

}  // namespace
}  // namespace insonate::test
