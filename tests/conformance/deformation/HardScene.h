#pragma once

#include "support/NeckScene.h"

#include <gtest/gtest.h>

#include <string>

namespace insonate::test {

/// The analytic plane seen by a probe that is turned in it, about the middle of its face.
class TurnedPlane : public TissuePlane {
 public:
  AnalyticPlane tissue;
  double turn_deg = 0;

  void sample(std::span<const PlanePoint> at, std::span<PlaneTissue> found) const override {
    const double turn = turn_deg * 3.14159265358979 / 180;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double x = std::cos(turn) * at[i].x_mm + std::sin(turn) * at[i].z_mm;
      const double z = -std::sin(turn) * at[i].x_mm + std::cos(turn) * at[i].z_mm;
      found[i] = tissue.of(x + tissue.slide_mm, z + tissue.press_mm);
    }
  }

  Transform patientFromProbe() const {
    const double turn = turn_deg * 3.14159265358979 / 180;
    Transform t;
    t.linear.column[0] = {std::cos(turn), 0, -std::sin(turn)};
    t.linear.column[2] = {std::sin(turn), 0, std::cos(turn)};
    t.offset = {tissue.slide_mm, 0, tissue.press_mm};
    return t;
  }
};

/// Questions to a model, whatever they are: what comes back is finite. Cells have one mean dilatation, so that single
/// corners turn over where tissue is folded sharply, at the rim of a vein that is nearly shut: a few points of the
/// displacement's lattice are then not one-to-one, and are counted.
class HardScene : public testing::Test {
 protected:
  HardScene() {
    plane.tissue = neckScene();
    bloodAsInTheCt();
  }

  void bloodAsInTheCt() { input.pressure = {table.of(kArtery).pressure_kPa, table.of(kVein).pressure_kPa}; }
  void make(int maxIterations = 60, double mesh_mm = 1) {
    model = makeDeformationModel(name, table, {.mesh_mm = mesh_mm, .maxIterations = maxIterations}).value();
  }

  const Deformation& ask(double press_mm) {
    if (!model) make();
    plane.tissue.press_mm = press_mm;
    input.plane = &plane;
    input.patientFromProbe = plane.patientFromProbe();
    model->solve(input, answer);
    ++asked;
    expectSane();
    return answer;
  }

  void expectSane() {
    const Folds folds = foldsOf(answer.displacement);
    int wrong = folds.notFinite;
    for (const MeshNode& node : answer.mesh)
      wrong += !std::isfinite(node.x_mm + node.z_mm + node.restX_mm + node.restZ_mm);
    for (const float p : answer.pressure_kPa) wrong += !std::isfinite(p);
    for (const LumenArea& lumen : answer.lumens)
      wrong += !(lumen.area_mm2 >= 0 && std::isfinite(lumen.area_mm2) && lumen.rest_mm2 > 0);
    wrong += !std::isfinite(answer.force_N) || !std::isfinite(answer.faceShift_mm);
    EXPECT_EQ(wrong, 0) << scene();
    notConverged += !answer.converged;
    folded += folds.folded > 0;
    if (folds.folded > maxFolds) {
      maxFolds = folds.folded;
      maxFolded = scene();
    }
  }

  std::string scene() const {
    return table.name + ", question " + std::to_string(asked) + ": press " + std::to_string(plane.tissue.press_mm) +
           ", slide " + std::to_string(plane.tissue.slide_mm) + ", turn " + std::to_string(plane.turn_deg) +
           ", force " + std::to_string(input.force_N);
  }

  void TearDown() override {
    EXPECT_EQ(maxFolds, 0) << maxFolded;
    RecordProperty("asked", asked);
    RecordProperty("not_converged", notConverged);
    RecordProperty("folded", folded);
    RecordProperty("most_points_folded", maxFolds);
  }

  std::string name = "elastic";
  TurnedPlane plane;
  MechanicalTable table = loadMechanicalTable("measured").value();
  std::unique_ptr<DeformationModel> model;
  DeformationInput input;
  Deformation answer;
  int asked = 0, notConverged = 0, folded = 0, maxFolds = 0;
  std::string maxFolded;
};

}  // namespace insonate::test
