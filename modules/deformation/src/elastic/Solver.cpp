#include "elastic/Solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::elastic {
namespace {

constexpr float kHeld = 1e8f;
constexpr float kShut_kPa = 20;  // of cells in a closed lumen, and of gas between skin and skin
constexpr float kLongestStep_mm = 4;
constexpr float kFarthest_mm = 100;  // maximum motion of tissue
constexpr float kCaution = 0.1f;
constexpr int kCautiousRounds = 3;  // after a tangent that was not positive definite
constexpr float kBounded = 1e-3f;   // factor that limits pressures without damping
constexpr int kSettled = 5;         // number of steps after which an oscillation is assumed
constexpr float kToAndFro_mm = 0.1f;
constexpr int kDrawBacks = 5;

/// Derivatives of the shape functions with respect to the rest position, in the middle of a cell.
struct CellGradient {
  std::size_t corner[4];
  float x[4], z[4];

  CellGradient(const Nodes& rest, std::size_t n, int columns, float area)
      : corner{n, n + 1, n + 1 + columns, n + columns} {
    const float half = 0.5f / area;
    const float d1x = rest.x[corner[2]] - rest.x[corner[0]], d1z = rest.z[corner[2]] - rest.z[corner[0]];
    const float d2x = rest.x[corner[3]] - rest.x[corner[1]], d2z = rest.z[corner[3]] - rest.z[corner[1]];
    x[0] = -d2z * half, x[1] = d1z * half, x[2] = -x[0], x[3] = -x[1];
    z[0] = d2x * half, z[1] = -d1x * half, z[2] = -z[0], z[3] = -z[1];
  }
};

}  // namespace

void Solver::prepare(const Mesh& mesh, const Materials& materials, const MechanicalTable& tissues,
                     const Prestress* known) {
  const int nx = mesh.columns(), nz = mesh.rows();
  if (elements_.columns != nx || elements_.rows != nz) {
    elements_.resize(nx, nz);
    matrix_.resize(nx, nz);
    factor_.prepare(nx, nz);
    at_.resize(std::size_t(nx) * nz);
    for (auto* v : {&force_, &dead_, &step_, &byShift_, &response_})
      v->assign(2 * std::size_t(nx) * nz + 2 * GridMatrix::kPadding, 0.0f);
    cellPressure_.assign(elements_.base.size(), 0.0f);
    restBase_.assign(elements_.base.size(), 0.0f);
    prestress_.resize(elements_.base.size());
  }
  materials_ = &materials;
  rest_ = mesh.rest();
  restPressure_ = {tissues.of(kArtery).pressure_kPa, tissues.of(kVein).pressure_kPa};
  contact_.prepare(rest_, nx);
  struts_.prepare(mesh, materials);
  elements_.mu = materials.mu;
  shapeElements(rest_, elements_);
  for (std::size_t n = 0; n < elements_.count(); ++n) {
    elements_.bulk[n] = materials.bulk[n];
    elements_.hoop[n] = materials.hoop[n];
    elements_.base[n] = -materials.mu[n];
    const float blood = std::max(materials.arteryBlood[n], materials.veinBlood[n]);
    const bool gas = Materials::isGas(materials.mu[n]);
    elements_.shut[n] = kShut_kPa * (gas ? 1 : blood);
    const Collagen& collagen = materials.arteryBlood[n] > materials.veinBlood[n] ? kArteryCollagen : kVeinCollagen;
    elements_.full[n] = collagen.modulus_kPa * blood, elements_.fullAbove[n] = collagen.above;
    elements_.guarded[n] = !gas && blood < 0.3f ? 1.0f : 0.0f;
  }
  solid_.assign(materials.fixed.size(), 0);
  for (std::size_t n = 0; n < elements_.count(); ++n)
    if (elements_.guarded[n] > 0)
      for (const std::size_t corner : {n, n + 1, n + 1 + std::size_t(nx), n + nx}) solid_[corner] = 1;
  std::fill(dead_.begin(), dead_.end(), 0.0f);
  at_ = rest_;
  elements_.carried = elements_.base;
  if (materials.anyBlood) {
    if (known)
      prestress_ = *known;
    else
      findPrestress();
    applyPrestress();
  }
  restBase_ = elements_.base;
}

/// Stress with which the rest geometry balances the pressure of the blood, from a linear solution.
void Solver::findPrestress() {
  const auto a = static_cast<float>(restPressure_.artery_kPa), v = static_cast<float>(restPressure_.vein_kPa);
  std::vector<float>& base = elements_.base;
  elements_.carried = base;
  for (std::size_t n = 0; n < elements_.count(); ++n) {
    elements_.bulk[n] += elements_.hoop[n];  // blood resists changes of area
    base[n] -= a * materials_->arteryBlood[n] + v * materials_->veinBlood[n];
  }
  system(0);
  hold();
  step_ = force_;
  if (!factor_.factor(matrix_, step_)) std::fill(step_.begin(), step_.end(), 0.0f);
  base = elements_.carried;
  elements_.bulk = materials_->bulk;
  const int nx = elements_.columns;
  for (std::size_t n = 0; n < elements_.count(); ++n) {
    if (elements_.area[n] <= 0) continue;
    const CellGradient g(rest_, n, nx, elements_.area[n]);
    float xx = 0, xz = 0, zx = 0, zz = 0;
    for (int c = 0; c < 4; ++c) {
      const float ux = step_[2 * g.corner[c]], uz = step_[2 * g.corner[c] + 1];
      xx += ux * g.x[c], xz += ux * g.z[c], zx += uz * g.x[c], zz += uz * g.z[c];
    }
    const float mu = materials_->mu[n];
    prestress_.xx[n] = 2 * mu * xx;
    prestress_.zz[n] = 2 * mu * zz;
    prestress_.xz[n] = mu * (xz + zx);
    prestress_.volume[n] = (materials_->bulk[n] + materials_->hoop[n] - mu) * (xx + zz);
  }
}

/// Applies the stress as an initial stress of each cell (second Piola-Kirchhoff). It balances the pressure of the blood
/// except for the error of the cell means, which is a dead load.
void Solver::applyPrestress() {
  const auto a = static_cast<float>(restPressure_.artery_kPa), v = static_cast<float>(restPressure_.vein_kPa);
  const int nx = elements_.columns;
  for (std::size_t n = 0; n < elements_.count(); ++n) {
    const float area = elements_.area[n];
    if (area <= 0) continue;
    elements_.base[n] += prestress_.volume[n] - a * materials_->arteryBlood[n] - v * materials_->veinBlood[n];
    const float most = std::max({std::abs(prestress_.xx[n]), std::abs(prestress_.zz[n]), std::abs(prestress_.xz[n])});
    const float share = std::min(1.0f, 0.8f * materials_->mu[n] / std::max(most, 1e-6f));
    const float xx = share * area * prestress_.xx[n], zz = share * area * prestress_.zz[n],
                xz = share * area * prestress_.xz[n];
    const CellGradient g(rest_, n, nx, area);
    int k = 0;
    for (int p = 0; p < 4; ++p)
      for (int q = p; q < 4; ++q, ++k)
        elements_.m[k][n] += xx * g.x[p] * g.x[q] + zz * g.z[p] * g.z[q] + xz * (g.x[p] * g.z[q] + g.z[p] * g.x[q]);
  }
  std::fill(dead_.begin(), dead_.end(), 0.0f);
  system(0);
  for (std::size_t k = 0; k < dead_.size(); ++k) dead_[k] = -force_[k];
}

void Solver::setPressure(const BloodPressure& pressure) {
  const auto a = static_cast<float>(pressure.artery_kPa - restPressure_.artery_kPa);
  const auto v = static_cast<float>(pressure.vein_kPa - restPressure_.vein_kPa);
  atRestPressure_ = !materials_->anyBlood || (a == 0 && v == 0);
  for (std::size_t n = 0; n < elements_.count(); ++n) {
    const float now = restBase_[n] - a * materials_->arteryBlood[n] - v * materials_->veinBlood[n];
    elements_.carried[n] += now - elements_.base[n];
    elements_.base[n] = now;
  }
}

void Solver::start() {
  contact_.forget();
  at_ = rest_;
  elements_.carried = elements_.base;
  caution_ = 0;
  cautiousRounds_ = 0;
  rounds_ = 0;
  carried_ = false;
}

void Solver::carry() {
  for (std::size_t n = 0; n < materials_->fixed.size(); ++n)
    if (materials_->fixed[n]) at_.x[n] = rest_.x[n], at_.z[n] = rest_.z[n];
  for (std::size_t n = 0; n < elements_.count(); ++n) elements_.carried[n] = elements_.base[n] + cellPressure_[n];
  caution_ = kBounded;
  cautiousRounds_ = 1;
  rounds_ = 0;
  carried_ = true;
}

void Solver::hold() {
  for (std::size_t n = 0; n < materials_->fixed.size(); ++n)
    if (materials_->fixed[n]) {
      matrix_.value[0][n] += kHeld;
      matrix_.value[2][n] += kHeld;
      force_[2 * n] = force_[2 * n + 1] = 0;
    }
}

void Solver::system(float caution) {
  for (auto& array : matrix_.value) std::fill(array.begin(), array.end(), 0.0f);
  force_ = dead_;
  assemble(elements_, at_, caution, matrix_, force_);
  struts_.add(at_, matrix_, force_);
}

/// The change of shift after which the face has the required force, with the corresponding step.
float Solver::followForce(float wanted_kPa_mm, float shift_mm) {
  std::fill(byShift_.begin(), byShift_.end(), 0.0f);
  contact_.pushByShift(shift_mm, at_, byShift_);
  const float stiffness = contact_.sum(byShift_);
  if (stiffness <= 0) return contact_.gap(shift_mm, at_) + 0.02f;
  response_ = byShift_;
  factor_.solve(response_);
  const float now = contact_.pressing(shift_mm, at_) - contact_.product(byShift_, step_);
  const float slope = stiffness - contact_.product(byShift_, response_);
  const float change = std::clamp((wanted_kPa_mm - now) / std::max(slope, 1e-4f * stiffness), -2.0f, 2.0f);
  for (std::size_t k = 0; k < step_.size(); ++k) step_[k] += change * response_[k];
  return change;
}

/// Longest step of tissue; nodes inside blood are not limited.
float Solver::longestStep() const {
  float longest = 0;
  for (std::size_t n = 0; n < solid_.size(); ++n)
    if (solid_[n]) longest = std::max({longest, std::abs(step_[2 * n]), std::abs(step_[2 * n + 1])});
  return longest;
}

/// Also false if a position is not a number, which comparisons of steps would accept.
bool Solver::inReach() const {
  const auto far = [](float now, float rest) { return !(std::abs(now - rest) < kFarthest_mm); };
  for (std::size_t n = 0; n < materials_->fixed.size(); ++n)
    if (far(at_.x[n], rest_.x[n]) || far(at_.z[n], rest_.z[n])) return false;
  return true;
}

void Solver::pressed(const Load& load, float shift_mm) {
  system(caution_);
  contact_.add(shift_mm, load.sticking, at_, matrix_, force_);
  hold();
}

/// Slope of the energy along the last step; positive if the energy decreases backward.
float Solver::slope(const Load& load, float shift_mm, float shiftChange) const {
  double sum = 0;
  for (std::size_t k = 0; k < force_.size(); ++k) sum += double(force_[k]) * step_[k];
  if (shiftChange != 0) sum += (load.force_kPa_mm - contact_.pressing(shift_mm, at_)) * shiftChange;
  return static_cast<float>(sum);
}

/// Returns along the last step to just behind the minimum of the energy, if the step went far beyond it: at a contact
/// that one node gains and loses, full steps would oscillate forever. The place is just behind the minimum, so that the
/// next tangent includes the stiffer side.
void Solver::drawBack(const Load& load, float before, float shiftChange, float& shift_mm) {
  float low = 0, high = 1, ahead = before, behind = slope(load, shift_mm, shiftChange), here = 1;
  const auto go = [&](float to) {
    for (std::size_t n = 0; n < solid_.size(); ++n)
      at_.x[n] += (to - here) * step_[2 * n], at_.z[n] += (to - here) * step_[2 * n + 1];
    shift_mm += (to - here) * shiftChange;
    here = to;
    pressed(load, shift_mm);
    return slope(load, shift_mm, shiftChange);
  };
  for (int round = 0; round < kDrawBacks && behind < -0.1f * before; ++round) {
    const float share = std::clamp(ahead / (ahead - behind), 0.2f, 0.8f);
    const float to = low + (high - low) * share, now = go(to);
    if (now > 0)
      low = to, ahead = now;
    else
      high = to, behind = now;
  }
  if (here != high) go(high);
}

Solver::Outcome Solver::solve(const FaceProfile& face, Load load, const Patience& patience) {
  Outcome out;
  out.shift_mm = load.shift_mm;
  contact_.meet(face, at_);
  const bool carried = std::exchange(carried_, false);
  float shiftChange = 0, downhill = 0;
  bool toAndFro = false;
  for (; out.iterations < patience.maxIterations && !out.converged; ++out.iterations) {
    pressed(load, out.shift_mm);
    if (toAndFro) drawBack(load, downhill, shiftChange, out.shift_mm);
    step_ = force_;
    if (!factor_.factor(matrix_, step_)) {
      caution_ = std::max(kCaution, 3 * caution_);
      cautiousRounds_ = kCautiousRounds;
      toAndFro = false;
      continue;
    }
    shiftChange = load.force_kPa_mm > 0 ? followForce(load.force_kPa_mm, out.shift_mm) : 0;
    const float longest = std::max(std::abs(shiftChange), longestStep());
    if (!std::isfinite(longest)) return out;
    float share = std::min(1.0f, kLongestStep_mm / std::max(longest, 1e-9f));
    share = std::min(share, allowedShare(elements_, at_, step_));
    toAndFro =
        rounds_++ >= kSettled && share == 1 && longest > 0.5f * last_ && (longest < kToAndFro_mm || caution_ > 0);
    last_ = longest;
    if (toAndFro) downhill = slope(load, out.shift_mm, shiftChange);
    advance(elements_, at_, step_, share);
    contact_.settle();
    out.shift_mm += share * shiftChange;
    // A cautious step is shorter than the remaining distance.
    out.converged = share == 1 && out.iterations > 0 && longest < (caution_ > 0 ? 0.5f : 1.0f) * patience.tolerance_mm;
    if (carried && share == 1 && longest < patience.movingTolerance_mm) {
      ++out.iterations;
      break;
    }
    cautiousRounds_ = std::max(cautiousRounds_ - 1, 0);
    if (cautiousRounds_ == 0) caution_ = 0;
  }
  out.finite = inReach();
  if (!out.finite) {
    out.converged = false;
    out.shift_mm = 0;
    return out;
  }
  contact_.settle();
  contact_.remember(out.shift_mm, at_);
  out.force_kPa_mm = contact_.foreseen(out.shift_mm, at_);
  for (std::size_t n = 0; n < elements_.count(); ++n) cellPressure_[n] = elements_.carried[n] - elements_.base[n];
  return out;
}

}  // namespace insonate::elastic
