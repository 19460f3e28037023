#include "Calculix.h"
#include "support/NeckScene.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace insonate::test {
namespace {

/// The same block for a model and for CalculiX: 60 x 40 mm with free sides, or with what lies beyond to where the model
/// holds its tissue; a face of 38 mm is pressed into its top. CalculiX is told where the model's skin lies on the face;
/// everything else, and the force, are its own. Over held sides and over the vein presses are as far as its steps get
/// in a few minutes: beyond, they are cut down to nothing where elements fold, at the ends of the face and the vein's
/// rim.
class Calculix : public testing::Test {
 protected:
  void SetUp() override {
    if (!calculixIsThere()) GTEST_SKIP() << "CalculiX is not there (Debian: calculix-ccx)";
    block.tissue.young_kPa = 80;
    for (MechanicalTissue& tissue : table.tissues) tissue = {};
  }

  void inclusions() {
    plane.circles = {{-9, 15, 5, kVein}, {9, 15, 5, kArtery}};
    block.circles = {{-9, 15, 5, false, 0, {23, 0.49}}, {9, 15, 5, false, 0, {14000, 0.49}}};
    table.tissues[kVein].young_kPa = 23;
    table.tissues[kArtery].young_kPa = 14000;
  }
  void freeSides() {
    block.sidesHeld = false;
    plane.leftEnd_mm = -block.sides_mm;
    plane.rightEnd_mm = block.sides_mm;
  }

  void solveModel(double press_mm, double young_kPa) {
    for (const auto label : {kSoftTissue, kSkin}) table.tissues[label].young_kPa = young_kPa;
    block.tissue.young_kPa = young_kPa;
    plane.press_mm = press_mm;
    input.plane = &plane;
    input.patientFromProbe = plane.patientFromProbe();
    const auto model =
        makeDeformationModel("elastic", table, {.mesh_mm = 0.5, .depth_mm = block.height_mm - press_mm}).value();
    for (int k = 0; k < 5; ++k) model->solve(input, ours);
    EXPECT_TRUE(ours.converged);
    if (block.sidesHeld) block.sides_mm = ours.mesh[ours.meshColumns - 1].restX_mm;
  }

  /// Height of the face: flat, then an arc of 3 mm to 60 degrees.
  static double faceAt(double x_mm) {
    const double beyond = std::max(std::abs(x_mm) - 19, 0.0);
    return beyond < 2.6 ? std::sqrt(9 - beyond * beyond) - 3 : std::numeric_limits<double>::quiet_NaN();
  }

  /// Displacement that puts the model's skin at x onto the face.
  std::optional<std::array<double, 2>> pressAt(double x_mm) const {
    for (int i = 0; i + 1 < ours.meshColumns; ++i) {
      const MeshNode &a = ours.mesh[i], &b = ours.mesh[i + 1];
      if (x_mm < a.restX_mm || x_mm > b.restX_mm) continue;
      const auto touches = [&](const MeshNode& node) { return node.z_mm < faceAt(node.x_mm) + 0.01; };
      if (!touches(a) || !touches(b)) break;
      const double share = (x_mm - a.restX_mm) / (b.restX_mm - a.restX_mm);
      const double x = std::lerp(double(a.x_mm), double(b.x_mm), share);
      return std::array{x - x_mm, faceAt(x) + plane.press_mm};
    }
    return std::nullopt;
  }

  /// Displacement of a point of the tissue by the model, in its own mesh.
  PlanePoint moveAt(double x_mm, double z_mm) const {
    for (int j = 0; j + 1 < ours.meshRows; ++j)
      for (int i = 0; i + 1 < ours.meshColumns; ++i) {
        const MeshNode* n = &ours.mesh[std::size_t(j) * ours.meshColumns + i];
        const MeshNode corner[] = {n[0], n[1], n[ours.meshColumns + 1], n[ours.meshColumns]};
        for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
          const double ux = corner[b].restX_mm - corner[a].restX_mm, uz = corner[b].restZ_mm - corner[a].restZ_mm;
          const double vx = corner[c].restX_mm - corner[a].restX_mm, vz = corner[c].restZ_mm - corner[a].restZ_mm;
          const double px = x_mm - corner[a].restX_mm, pz = z_mm - corner[a].restZ_mm;
          const double det = ux * vz - uz * vx, s = (px * vz - pz * vx) / det, t = (ux * pz - uz * px) / det;
          if (s < -1e-4 || t < -1e-4 || s + t > 1 + 1e-4) continue;
          const auto move = [&](int k) {
            return std::array{double(corner[k].x_mm - corner[k].restX_mm), double(corner[k].z_mm - corner[k].restZ_mm)};
          };
          const auto ma = move(a), mb = move(b), mc = move(c);
          return {float(ma[0] + s * (mb[0] - ma[0]) + t * (mc[0] - ma[0])),
                  float(ma[1] + s * (mb[1] - ma[1]) + t * (mc[1] - ma[1]))};
        }
      }
    ADD_FAILURE() << "outside of the mesh: " << x_mm << " " << z_mm;
    return {};
  }

  /// RMS over CalculiX's nodes, and the force's error. Not where free sides end in cells that are half air: the model's
  /// mesh follows the skin's height only.
  void compare(const std::string& name) {
    block.press = [this](double x_mm) { return pressAt(x_mm); };
    const auto folder = std::filesystem::path(INSONATE_BINARY_DIR) / "Testing" / "calculix" / name;
    theirs = solveWithCalculix(block, folder);
    ASSERT_TRUE(theirs.ran) << "see " << folder / "block.log";
    const double end_mm = block.sides_mm - (block.sidesHeld ? 0 : 4);
    double sum = 0, worst = 0;
    int count = 0;
    for (const CalculixNode& node : theirs.nodes) {
      if (std::abs(node.x_mm) > end_mm) continue;
      ++count;
      const PlanePoint move = moveAt(node.x_mm, node.z_mm - plane.press_mm);
      const double d = std::hypot(move.x_mm - node.moveX_mm, move.z_mm - node.moveZ_mm);
      sum += d * d;
      worst = std::max(worst, d);
    }
    rms_mm = std::sqrt(sum / count);
    const double force_kPa_mm = ours.force_N * 1000 / input.face.footprint_mm;
    forceRatio = force_kPa_mm / theirs.force_kPa_mm;
    RecordProperty("rms_mm", std::to_string(rms_mm));
    RecordProperty("most_mm", std::to_string(worst));
    RecordProperty("force_kPa_mm", std::to_string(force_kPa_mm));
    RecordProperty("force_ratio", std::to_string(forceRatio));
  }

  AnalyticPlane plane;
  MechanicalTable table;
  DeformationInput input;
  CalculixBlock block;
  Deformation ours;
  CalculixAnswer theirs;
  double rms_mm = 0, forceRatio = 0;
};

TEST_F(Calculix, SoftAndHardInclusions) {
  inclusions();
  solveModel(2, 80);
  compare("inclusions");
  EXPECT_LT(rms_mm, 0.05);
  EXPECT_NEAR(forceRatio, 1, 0.1);
}

TEST_F(Calculix, PressedByAQuarter) {
  inclusions();
  freeSides();
  input.face.sticking = true;  // else a block with one hard inclusion slides out from under the face
  solveModel(10, 80);
  compare("quarter");
  // 1.3 % of the press; most of it at the ends of the face, where the meshes touch it differently.
  EXPECT_LT(rms_mm, 0.15);
  EXPECT_NEAR(forceRatio, 1, 0.1);
}

class CalculixVein : public Calculix, public testing::WithParamInterface<int> {};

TEST_P(CalculixVein, HollowUnderPressure) {
  const double pressure_kPa = GetParam() * 0.133322;
  plane.circles = {{0, 15, 6, kVein}};
  block.circles = {{0, 15, 6, true, pressure_kPa, {}}};
  table.tissues[kVein].kind = Mechanics::Lumen;
  input.pressure.vein_kPa = pressure_kPa;
  solveModel(3, 10);
  compare("vein" + std::to_string(GetParam()));
  const double area = areaRatio(ours, kVein), other = theirs.area_mm2[0] / theirs.rest_mm2[0];
  RecordProperty("area", std::to_string(area));
  RecordProperty("area_calculix", std::to_string(other));
  EXPECT_LT(rms_mm, 0.05);
  EXPECT_NEAR(forceRatio, 1, 0.1);
  EXPECT_NEAR(area, other, 0.03);
}

INSTANTIATE_TEST_SUITE_P(mmHg, CalculixVein, testing::Values(0, 3, 6, 12));

}  // namespace
}  // namespace insonate::test
