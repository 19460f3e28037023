#include "Models.h"
#include "elastic/CarryOver.h"
#include "elastic/InverseMap.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using namespace elastic;

constexpr float kTolerance_mm = 0.01f;

/// Motion of the probe after which the vessels' prestress is computed again; a rotation counts as the motion of the end
/// of this arm.
constexpr double kStressLasts_mm = 2;
constexpr double kArm_mm = 20;

class ElasticModel final : public DeformationModel {
 public:
  ElasticModel(const MechanicalTable& tissues, const DeformationSettings& settings)
      : tissues_(tissues), settings_(settings) {}

  std::string_view name() const override { return "elastic"; }
  void reset() override { known_ = solved_ = false; }

  void solve(const DeformationInput& input, Deformation& answer) override {
    const bool carried = place(input);
    solver_.setPressure(input.pressure);
    const FaceProfile face(input.face);
    if (input.force_N <= 0 && solver_.atRestPressure() && !touchesAtRest(face)) {
      solved_ = false;
      describe(input, {0, true, true, 0, 0}, answer);
      return;
    }
    Solver::Load load;
    load.force_kPa_mm = static_cast<float>(input.force_N * 1000 / input.face.footprint_mm);
    load.shift_mm = load.force_kPa_mm > 0 ? shift_ : 0;
    load.sticking = input.face.sticking;
    const Solver::Patience patience{settings_.maxIterations,
                                    settings_.tolerance_mm > 0 ? float(settings_.tolerance_mm) : kTolerance_mm,
                                    static_cast<float>(settings_.movingTolerance_mm)};
    bool found = carried && attempt(input, face, load, patience, answer);
    if (!found) {
      // Starts from rest: in the first solution, or if the transferred solution failed.
      solver_.start();
      load.shift_mm = 0;
      found = attempt(input, face, load, patience, answer);
    }
    if (!found) {
      solver_.start();
      solved_ = false;
      describe(input, {answer.iterations, false, false, 0, 0}, answer);
    }
    answer.moved = true;
  }

 private:
  /// False if tissue moved too far, or if cells inverted over a large region.
  bool attempt(const DeformationInput& input, const FaceProfile& face, const Solver::Load& load,
               const Solver::Patience& patience, Deformation& answer) {
    const Solver::Outcome outcome = solver_.solve(face, load, patience);
    solved_ = outcome.finite;
    shift_ = outcome.shift_mm;
    return describe(input, outcome, answer) && solved_;
  }

  /// Builds mesh and stiffness at the present pose. True if the last solution was transferred.
  bool place(const DeformationInput& input) {
    const bool same = known_ && input.patientFromProbe && last_ && *last_ == *input.patientFromProbe &&
                      plane_ == input.plane && face_.width_mm == input.face.width_mm &&
                      face_.radius_mm == input.face.radius_mm;
    plane_ = input.plane;
    face_ = input.face;
    if (same) return solved_;
    const bool carry = solved_ && input.patientFromProbe && last_;
    if (carry) before_.keep(mesh_, solver_);
    mesh_.build(*input.plane, input.face, settings_);
    materials_.fill(mesh_, *input.plane, tissues_);
    const bool lasts = carry && stressLasts(*input.patientFromProbe);
    solver_.prepare(mesh_, materials_, tissues_, lasts ? &carriedStress_ : nullptr);
    if (!lasts && input.patientFromProbe) {
      stressed_.keep(mesh_, solver_);
      stressFound_ = *input.patientFromProbe;
    }
    if (carry) before_.shareSolution(mesh_, materials_, inverted(*last_) * *input.patientFromProbe, solver_);
    last_ = input.patientFromProbe;
    known_ = true;
    return carry;
  }

  /// Transfers the vessels' prestress from the pose of its computation, if that is near; otherwise it must be computed
  /// again.
  bool stressLasts(const Transform& patientFromProbe) {
    const Transform foundFromNow = inverted(stressFound_) * patientFromProbe;
    const Vec3 turned = foundFromNow.linear * Vec3{kArm_mm, 0, 0} - Vec3{kArm_mm, 0, 0};
    if (stressed_.fits(mesh_) && norm(foundFromNow.offset) + norm(turned) < kStressLasts_mm) {
      stressed_.transferStress(mesh_, materials_, foundFromNow, carriedStress_);
      return true;
    }
    return false;
  }

  bool touchesAtRest(const FaceProfile& face) {
    for (int i = 0; i < mesh_.columns(); ++i)
      if (const FaceProfile::Point p = face.at(mesh_.rest().x[i]); p.under && p.z_mm > mesh_.rest().z[i] + 1e-3f)
        return true;
    return false;
  }

  double areaOf(const std::vector<float>& share, const Nodes& nodes) const {
    const int nx = mesh_.columns();
    double sum = 0;
    for (std::size_t n = 0; n < std::size_t(nx) * (mesh_.rows() - 1); ++n) {
      if (share[n] <= 0) continue;
      const float d1x = nodes.x[n + 1 + nx] - nodes.x[n], d1z = nodes.z[n + 1 + nx] - nodes.z[n];
      const float d2x = nodes.x[n + nx] - nodes.x[n + 1], d2z = nodes.z[n + nx] - nodes.z[n + 1];
      sum += 0.5 * share[n] * std::max(d1x * d2z - d1z * d2x, 0.0f);
    }
    return sum;
  }

  /// False if the displacement is not one-to-one.
  bool describe(const DeformationInput& input, const Solver::Outcome& outcome, Deformation& answer) {
    const Nodes &rest = mesh_.rest(), &now = solved_ ? solver_.at() : rest;
    answer.force_N = outcome.force_kPa_mm * input.face.footprint_mm / 1000;
    answer.faceShift_mm = outcome.shift_mm;
    answer.iterations = outcome.iterations;
    answer.converged = outcome.converged;
    answer.moved = false;
    answer.lumens.clear();
    for (const auto& [label, share] : {std::pair{kArtery, &materials_.artery}, std::pair{kVein, &materials_.vein}})
      if (const double area = areaOf(*share, rest); area > 0)
        answer.lumens.push_back({label, solved_ ? areaOf(*share, now) : area, area});
    answer.meshColumns = mesh_.columns();
    answer.meshRows = mesh_.rows();
    const std::size_t nodes = std::size_t(mesh_.columns()) * mesh_.rows();
    answer.mesh.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n) answer.mesh[n] = {rest.x[n], rest.z[n], now.x[n], now.z[n]};
    answer.pressure_kPa.resize(std::size_t(mesh_.columns() - 1) * (mesh_.rows() - 1));
    for (int j = 0; j + 1 < mesh_.rows(); ++j)
      for (int i = 0; i + 1 < mesh_.columns(); ++i)
        answer.pressure_kPa[std::size_t(j) * (mesh_.columns() - 1) + i] =
            solved_ ? -solver_.cellPressure()[std::size_t(j) * mesh_.columns() + i] : 0;
    if (!solved_) {
      answer.displacement.columns = answer.displacement.rows = 0;
      answer.displacement.restFromDisplayed.clear();
      return true;
    }
    InverseMapExtent extent;
    extent.half_mm = mesh_.lines().across.end_mm() + 5;
    extent.bottom_mm = static_cast<float>(settings_.depth_mm);
    return invertMesh(mesh_, now, extent, folded_, answer.displacement);
  }

  MechanicalTable tissues_;
  DeformationSettings settings_;
  Mesh mesh_;
  CarryOver before_, stressed_;
  Prestress carriedStress_;
  Transform stressFound_;
  Materials materials_;
  Solver solver_;
  std::vector<int> folded_;
  std::optional<Transform> last_;
  const TissuePlane* plane_ = nullptr;
  ProbeFace face_;
  bool known_ = false, solved_ = false;
  float shift_ = 0;
};

}  // namespace

std::unique_ptr<DeformationModel> makeElasticModel(const MechanicalTable& tissues,
                                                   const DeformationSettings& settings) {
  return std::make_unique<ElasticModel>(tissues, settings);
}

}  // namespace insonate
