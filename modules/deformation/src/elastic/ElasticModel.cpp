#include "elastic/ElasticModel.h"

#include "elastic/InverseMap.h"
#include "elastic/Solver.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using namespace elastic;

constexpr float kTolerance_mm = 0.01f;

/// Where a point of one pose's plane lies in another's; what is off the plane is left out.
struct PlaneMove {
  float xx = 1, xz = 0, zx = 0, zz = 1, x = 0, z = 0;

  PlaneMove() = default;
  explicit PlaneMove(const Transform& to_from_from)
      : xx(float(to_from_from.linear.column[0].x)),
        xz(float(to_from_from.linear.column[2].x)),
        zx(float(to_from_from.linear.column[0].z)),
        zz(float(to_from_from.linear.column[2].z)),
        x(float(to_from_from.offset.x)),
        z(float(to_from_from.offset.z)) {}
  PlanePoint turn(float px, float pz) const { return {xx * px + xz * pz, zx * px + zz * pz}; }
  PlanePoint turnBack(float px, float pz) const { return {xx * px + zx * pz, xz * px + zz * pz}; }
};

class ElasticModel final : public DeformationModel {
 public:
  ElasticModel(const MechanicalTable& tissues, const DeformationSettings& settings)
      : tissues_(tissues), settings_(settings) {}

  std::string_view name() const override { return "elastic"; }
  void reset() override { known_ = solved_ = false; }

  void solve(const DeformationInput& input, Deformation& answer) override {
    const bool carried = place(input);
    solver_.setPressure(input.pressure);
    const Face face(input.face);
    if (input.force_N <= 0 && solver_.atRestPressure() && !touchesAtRest(face)) {
      solved_ = false;
      describe(input, {0, true, true, 0, 0}, answer);
      return;
    }
    Solver::Load load;
    load.force_kPa_mm = static_cast<float>(input.force_N * 1000 / input.face.footprint_mm);
    load.shift_mm = load.force_kPa_mm > 0 ? shift_ : 0;
    load.sticking = input.face.sticking;
    const float tolerance = settings_.tolerance_mm > 0 ? float(settings_.tolerance_mm) : kTolerance_mm;
    if (!carried) solver_.start();
    Solver::Outcome outcome = solver_.solve(face, load, settings_.mostIterations, tolerance);
    if (!outcome.finite) {
      solver_.start();
      load.shift_mm = 0;
      outcome = solver_.solve(face, load, settings_.mostIterations, tolerance);
    }
    if (!outcome.finite) solver_.start();
    solved_ = outcome.finite;
    shift_ = outcome.shift_mm;
    describe(input, outcome, answer);
    answer.moved = true;
  }

 private:
  /// Mesh and stiffness for where the probe is now. True where the last solution has been carried over.
  bool place(const DeformationInput& input) {
    const bool same = known_ && input.patientFromProbe && last_ && *last_ == *input.patientFromProbe &&
                      plane_ == input.plane && face_.width_mm == input.face.width_mm;
    plane_ = input.plane;
    face_ = input.face;
    if (same) return solved_;
    const bool carry = solved_ && input.patientFromProbe && last_;
    PlaneMove move;
    if (carry) move = PlaneMove(inverted(*last_) * *input.patientFromProbe);
    if (carry) {
      before_ = mesh_;
      atBefore_ = solver_.at();
      pressureBefore_ = solver_.cellPressure();
    }
    mesh_.build(*input.plane, input.face, settings_);
    materials_.fill(mesh_, tissues_);
    solver_.prepare(mesh_, materials_, tissues_);
    last_ = input.patientFromProbe;
    known_ = true;
    if (carry) carryOver(move);
    return carry;
  }

  void carryOver(const PlaneMove& beforeFromNow) {
    const int nx = mesh_.columns(), nz = mesh_.rows(), was = before_.columns();
    const Nodes &rest = mesh_.rest(), &restBefore = before_.rest();
    Nodes& at = solver_.at();
    std::vector<float>& pressure = solver_.cellPressure();
    const auto shiftX = [&](std::size_t n) { return atBefore_.x[n] - restBefore.x[n]; };
    const auto shiftZ = [&](std::size_t n) { return atBefore_.z[n] - restBefore.z[n]; };
    for (int j = 0; j < nz; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::size_t n = std::size_t(j) * nx + i;
        const PlanePoint p = beforeFromNow.turn(rest.x[n], rest.z[n]);
        const Mesh::Place place = before_.placeOf(p.x_mm + beforeFromNow.x, p.z_mm + beforeFromNow.z);
        const int c = std::min(static_cast<int>(place.column), was - 2);
        const int r = std::min(static_cast<int>(place.row), before_.rows() - 2);
        const float u = place.column - c, v = place.row - r;
        const std::size_t o = std::size_t(r) * was + c;
        const auto blend = [&](const auto& f) {
          return (1 - v) * ((1 - u) * f(o) + u * f(o + 1)) + v * ((1 - u) * f(o + was) + u * f(o + was + 1));
        };
        const PlanePoint shift = beforeFromNow.turnBack(blend(shiftX), blend(shiftZ));
        at.x[n] = rest.x[n] + shift.x_mm;
        at.z[n] = rest.z[n] + shift.z_mm;
        // A cell takes the pressure of the one in which its corner, moved half a cell in, lay.
        if (i + 1 < nx && j + 1 < nz) {
          const int cc = std::min(static_cast<int>(place.column + 0.5f), was - 2);
          const int rr = std::min(static_cast<int>(place.row + 0.5f), before_.rows() - 2);
          pressure[n] = pressureBefore_[std::size_t(rr) * was + cc];
        }
      }
    solver_.carry();
  }

  bool touchesAtRest(const Face& face) {
    for (int i = 0; i < mesh_.columns(); ++i)
      if (const Face::Point p = face.at(mesh_.rest().x[i]); p.under && p.z_mm > mesh_.rest().z[i] + 1e-3f) return true;
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

  void describe(const DeformationInput& input, const Solver::Outcome& outcome, Deformation& answer) {
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
      answer.displacement.restFromSeen.clear();
      return;
    }
    InverseMapExtent extent;
    extent.half_mm = mesh_.lines().fineHalf_mm + 5;
    extent.bottom_mm = static_cast<float>(settings_.depth_mm);
    invertMesh(mesh_, now, extent, answer.displacement);
  }

  MechanicalTable tissues_;
  DeformationSettings settings_;
  Mesh mesh_, before_;
  Materials materials_;
  Solver solver_;
  Nodes atBefore_;
  std::vector<float> pressureBefore_;
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
