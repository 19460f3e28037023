#pragma once

#include "support/AnalyticPlane.h"

#include <insonate/deformation/DeformationModel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace insonate::test {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Soft tissue 10 kPa, fat 4, muscle 25, skin 100; bone and background infinite; vessels as solids.
inline MechanicalTable columnTissues() {
  MechanicalTable table;
  table.tissues[kFat].young_kPa = 4;
  table.tissues[kMuscle].young_kPa = 25;
  table.tissues[kSkin].young_kPa = 100;
  table.tissues[kBone].young_kPa = kInfinite;
  table.tissues[kBackground].young_kPa = kInfinite;
  table.tissues[kVein].young_kPa = 5;
  table.tissues[kArtery].young_kPa = 200;
  return table;
}

/// The column model on a plane; cells of 0.5 mm, the bottom 40 mm below the face, unless said otherwise.
class ColumnRig : public testing::Test {
 protected:
  AnalyticPlane plane;
  MechanicalTable tissues = columnTissues();
  DeformationSettings settings{.mesh_mm = 0.5, .depth_mm = 40};
  ProbeFace face;

  Deformation solved(double force_N = 0) {
    DeformationInput input;
    input.plane = &plane;
    input.face = face;
    input.force_N = force_N;
    Deformation answer;
    (*makeDeformationModel("column", tissues, settings))->solve(input, answer);
    return answer;
  }

  static int middle(const Deformation& answer) { return answer.displacement.columns / 2; }

  /// Rest position of the tissue that is seen at (x of the column, z).
  static double restOf(const Deformation& answer, int column, int row) {
    const PlaneDisplacement& d = answer.displacement;
    return d.top_mm + row * d.step_mm + d.restFromDisplayed[std::size_t(row) * d.columns + column].z_mm;
  }
  static double seenZ(const Deformation& answer, int row) {
    return answer.displacement.top_mm + row * answer.displacement.step_mm;
  }
  static int rowAt(const Deformation& answer, double z_mm) {
    return static_cast<int>(std::lround((z_mm - answer.displacement.top_mm) / answer.displacement.step_mm));
  }

  /// The model's forward map of a rest point, between the nodes of its mesh.
  static double forward(const Deformation& answer, int column, double rest_mm) {
    const auto node = [&](int r) { return answer.mesh[std::size_t(r) * answer.meshColumns + column]; };
    int r = 0;
    while (r + 2 < answer.meshRows && node(r + 1).restZ_mm <= rest_mm) ++r;
    const double share = (rest_mm - node(r).restZ_mm) / (node(r + 1).restZ_mm - node(r).restZ_mm);
    return node(r).z_mm + share * (node(r + 1).z_mm - node(r).z_mm);
  }
};

}  // namespace insonate::test
