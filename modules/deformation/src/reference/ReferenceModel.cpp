#include "Models.h"
#include "elastic/InverseMap.h"
#include "reference/Equilibrium.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using namespace reference;

constexpr double kTolerance_mm = 1e-4, kRough_mm = 0.02;
constexpr double kPressStep_mm = 1, kForceStep_N = 0.5;
constexpr int kMaxRounds = 40;
constexpr double kMaxMissed_mm = 5e-3;       // maximum distance of a node from the face at the end
constexpr double kSmallestPart = 1.0 / 256;  // share of the load below which the solution stops

class ReferenceModel final : public DeformationModel {
 public:
  ReferenceModel(const MechanicalTable& tissues, const DeformationSettings& settings)
      : tissues_(tissues), settings_(settings) {
    settings_.mesh_mm = std::max(settings.mesh_mm / 2, 0.05);
  }

  std::string_view name() const override { return "reference"; }
  void reset() override {}

  void solve(const DeformationInput& input, Deformation& answer) override {
    elastic::Mesh mesh;
    mesh.build(*input.plane, input.face, settings_);
    elastic::Materials materials;
    materials.fill(mesh, *input.plane, tissues_);
    atRest_ = {tissues_.of(kArtery).pressure_kPa, tissues_.of(kVein).pressure_kPa};
    const FaceProfile face(input.face);
    const Body body = makeBody(mesh, materials, atRest_);
    Equilibrium equilibrium(body);
    answer.iterations = 0;
    answer.converged = true;
    deepest_mm_ = deepest(body, face);
    const bool sameBlood =
        input.pressure.artery_kPa == atRest_.artery_kPa && input.pressure.vein_kPa == atRest_.vein_kPa;
    answer.moved = input.force_N > 0 || deepest_mm_ > 1e-3 || (materials.anyBlood && !sameBlood);
    reached_ = partOf(0, input, face);
    reached_.meeting = body.rest;
    if (answer.moved) raiseLoad(input, face, equilibrium, answer);
    describe(input, mesh, body, equilibrium.state, answer);
    describeLumens(materials, body, equilibrium.state, answer);
  }

 private:
  /// Maximum depth of the face in the tissue at rest.
  static double deepest(const Body& body, const FaceProfile& face) {
    double depth = 0;
    for (int i = 0; i < body.columns; ++i)
      if (const auto p = face.at(static_cast<float>(body.rest[2 * i])); p.under)
        depth = std::max(depth, p.z_mm - body.rest[2 * i + 1]);
    return depth;
  }

  /// A part of the load: the face moves from its first contact, and pressures change with it.
  Load partOf(double part, const DeformationInput& input, const FaceProfile& face) const {
    Load load;
    load.blood.artery_kPa = std::lerp(atRest_.artery_kPa, input.pressure.artery_kPa, part);
    load.blood.vein_kPa = std::lerp(atRest_.vein_kPa, input.pressure.vein_kPa, part);
    load.face = &face;
    load.shift_mm = (part - 1) * deepest_mm_;
    load.sticking = input.face.sticking;
    return load;
  }

  /// Increases the load in steps, which are halved after a failure. The last equilibrium is the answer.
  void raiseLoad(const DeformationInput& input, const FaceProfile& face, Equilibrium& equilibrium,
                 Deformation& answer) {
    const double force_kPa_mm = std::max(input.force_N, 0.0) * 1000 / input.face.footprint_mm;
    const double steps = input.force_N > 0 ? input.force_N / kForceStep_N : deepest_mm_ / kPressStep_mm;
    double missed_mm = 0;
    const auto solve = [&](Load load, double part, double tolerance_mm) {
      const auto out = equilibrium.solve(load, part * force_kPa_mm, tolerance_mm, settings_.maxIterations);
      answer.iterations += out.iterations;
      missed_mm = out.missed_mm;
      if (!out.converged || !equilibrium.inOrder()) return false;
      reached_ = load;
      return true;
    };
    double done = 0, step = 1 / std::clamp(std::ceil(steps), 1.0, 100.0);
    while (done < 1 && step >= kSmallestPart) {
      const Equilibrium::State before = equilibrium.state;
      const double part = done + step > 1 - 1e-9 ? 1 : done + step;
      if (solve(partOf(part, input, face), part, kRough_mm)) {
        done = part;
      } else {
        equilibrium.state = before;
        step /= 2;
      }
    }
    const double tolerance_mm = settings_.tolerance_mm > 0 ? settings_.tolerance_mm : kTolerance_mm;
    answer.converged = done == 1;
    // Repeats until nodes lie on the face at the positions to which they have slid; each round moves half the distance,
    // since the edge of the face is steep.
    Vector meeting = equilibrium.state.at;
    for (int round = 0; round < kMaxRounds && answer.converged && (round == 0 || missed_mm > tolerance_mm); ++round) {
      const Equilibrium::State before = equilibrium.state;
      meeting = (meeting + equilibrium.state.at) / 2;
      Load load = partOf(1, input, face);
      load.meeting = meeting;
      answer.converged = solve(load, 1, tolerance_mm);
      if (!answer.converged) equilibrium.state = before;
    }
    answer.converged = answer.converged && missed_mm <= kMaxMissed_mm;
  }

  void describe(const DeformationInput& input, const elastic::Mesh& mesh, const Body& body,
                const Equilibrium::State& state, Deformation& answer) const {
    const Load& load = reached_;
    answer.force_N = faceForceOf(body, state.at, load) * input.face.footprint_mm / 1000;
    answer.faceShift_mm = input.force_N > 0 ? state.shift_mm : 0;
    answer.meshColumns = body.columns;
    answer.meshRows = body.rows;
    answer.mesh.resize(body.nodes());
    elastic::Nodes now = mesh.rest();
    for (int n = 0; n < body.nodes(); ++n) {
      now.x[n] = static_cast<float>(state.at[2 * n]);
      now.z[n] = static_cast<float>(state.at[2 * n + 1]);
      answer.mesh[n] = {mesh.rest().x[n], mesh.rest().z[n], now.x[n], now.z[n]};
    }
    answer.pressure_kPa.resize(body.cells.size());
    for (std::size_t n = 0; n < body.cells.size(); ++n) {
      const Cell& cell = body.cells[n];
      const double value = tensionOf(cell, load.blood, areaOf(cell, state.at)).value;
      answer.pressure_kPa[n] = static_cast<float>(tensionOf(cell, load.blood, cell.area).value - value);
    }
    answer.displacement.columns = answer.displacement.rows = 0;
    answer.displacement.restFromDisplayed.clear();
    if (!answer.moved) return;
    elastic::InverseMapExtent extent;
    extent.half_mm = mesh.lines().across.end_mm() + 5;
    extent.bottom_mm = static_cast<float>(settings_.depth_mm);
    std::vector<int> folded;
    invertMesh(mesh, now, extent, folded, answer.displacement);
  }

  static void describeLumens(const elastic::Materials& materials, const Body& body, const Equilibrium::State& state,
                             Deformation& answer) {
    answer.lumens.clear();
    for (const auto& [label, share] : {std::pair{kArtery, &materials.artery}, std::pair{kVein, &materials.vein}}) {
      LumenArea lumen{label, 0, 0};
      for (const Cell& cell : body.cells) {
        lumen.area_mm2 += (*share)[cell.node[0]] * std::max(areaOf(cell, state.at), 0.0);
        lumen.rest_mm2 += (*share)[cell.node[0]] * cell.area;
      }
      if (lumen.rest_mm2 > 0) answer.lumens.push_back(lumen);
    }
  }

  MechanicalTable tissues_;
  DeformationSettings settings_;
  BloodPressure atRest_;
  double deepest_mm_ = 0;
  Load reached_;
};

}  // namespace

std::unique_ptr<DeformationModel> makeReferenceModel(const MechanicalTable& tissues,
                                                     const DeformationSettings& settings) {
  return std::make_unique<ReferenceModel>(tissues, settings);
}

}  // namespace insonate
