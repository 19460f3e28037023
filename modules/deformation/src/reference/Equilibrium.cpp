#include "reference/Equilibrium.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate::reference {
namespace {

constexpr double kLongestStep_mm = 4;
constexpr double kMaxLoss = 0.6;    // maximum loss of a cell's area in a step
constexpr int kCautiousRounds = 3;  // after a tangent that was not positive definite

/// Numbers the nodes of a rectangle so that those on its middle line are last, and its halves in the same way (nested
/// dissection), which keeps the factor small.
void number(const Body& body, int left, int right, int top, int bottom, int& next, std::vector<int>& unknown) {
  if (left >= right || top >= bottom) return;
  const auto numberAll = [&](int l, int r, int t, int b) {
    for (int j = t; j < b; ++j)
      for (int i = l; i < r; ++i)
        for (const int k : {2 * (j * body.columns + i), 2 * (j * body.columns + i) + 1})
          if (!body.fixed[k]) unknown[k] = next++;
  };
  if ((right - left) * (bottom - top) <= 9) return numberAll(left, right, top, bottom);
  if (right - left >= bottom - top) {
    const int middle = (left + right) / 2;
    number(body, left, middle, top, bottom, next, unknown);
    number(body, middle + 1, right, top, bottom, next, unknown);
    numberAll(middle, middle + 1, top, bottom);
  } else {
    const int middle = (top + bottom) / 2;
    number(body, left, right, top, middle, next, unknown);
    number(body, left, right, middle + 1, bottom, next, unknown);
    numberAll(left, right, middle, middle + 1);
  }
}

}  // namespace

Equilibrium::Equilibrium(const Body& body) : body_(body), unknown_(2 * body.nodes(), -1) {
  number(body, 0, body.columns, 0, body.rows, unknowns_, unknown_);
  state.at = body.rest;
  for (const Cell& cell : body.cells) state.tension.push_back(cell.initial);
}

bool Equilibrium::factor(const Load& load, bool cautious) {
  const double most = cautious ? 1 : std::numeric_limits<double>::infinity();
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& e : tangentOf(body_, state.at, load, state.tension, most))
    if (const int row = unknown_[e.row()], column = unknown_[e.col()]; column >= 0 && row >= column)
      entries.emplace_back(row, column, e.value());
  Matrix matrix(unknowns_, unknowns_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (!analysed_) factor_.analyzePattern(matrix);
  analysed_ = true;
  factor_.factorize(matrix);
  return factor_.info() == Eigen::Success && factor_.vectorD().minCoeff() > 0;
}

Vector Equilibrium::solveWith(const Vector& right) const {
  Vector some(unknowns_), all = Vector::Zero(right.size());
  for (int k = 0; k < right.size(); ++k)
    if (unknown_[k] >= 0) some[unknown_[k]] = right[k];
  some = factor_.solve(some);
  for (int k = 0; k < right.size(); ++k)
    if (unknown_[k] >= 0) all[k] = some[unknown_[k]];
  return all;
}

Vector Equilibrium::step(const Load& load) {
  if (!factor(load, false)) return Vector::Zero(state.at.size());
  return solveWith(-gradientOf(body_, state.at, load));
}

/// The change of shift after which the face has the required force; adds the corresponding part to the step.
double Equilibrium::followForce(const Load& load, double wanted_kPa_mm, Vector& step) const {
  Vector byShift = Vector::Zero(step.size());
  double gap = std::numeric_limits<double>::infinity();
  for (int column = 0; column < body_.columns; ++column) {
    byShift[2 * column + 1] = touchOf(body_, state.at, load, column).stiffness_kPa;
    if (const auto profile = load.face->at(static_cast<float>(load.meeting[2 * column])); profile.under)
      gap = std::min(gap, state.at[2 * column + 1] - profile.z_mm - load.shift_mm);
  }
  const double stiffness = byShift.sum();
  if (stiffness <= 0) return gap + 0.02;
  const Vector response = solveWith(byShift);
  const double next = faceForceOf(body_, state.at, load) - byShift.dot(step);
  const double slope = std::max(stiffness - byShift.dot(response), 1e-6 * stiffness);
  const double change = std::clamp((wanted_kPa_mm - next) / slope, -1.0, 1.0);
  step += change * response;
  return change;
}

double Equilibrium::allowedShare(const Vector& step) const {
  double share = std::min(1.0, kLongestStep_mm / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
  for (const Cell& cell : body_.cells) {
    if (cell.artery + cell.vein >= 0.3) continue;
    const double loss = areaOf(cell, state.at) - areaOf(cell, state.at + step);
    const double allowed = kMaxLoss * areaOf(cell, state.at);
    if (loss > allowed) share = std::min(share, std::max(allowed, 0.0) / loss);
  }
  return share;
}

double Equilibrium::missedBy(const Load& load) const {
  double missed = 0;
  for (int column = 0; column < body_.columns; ++column) {
    if (touchOf(body_, state.at, load, column).depth_mm <= 0) continue;
    const auto met = load.face->at(static_cast<float>(load.meeting[2 * column]));
    const auto now = load.face->at(static_cast<float>(state.at[2 * column]));
    missed = std::max<double>(missed, now.under ? std::abs(now.z_mm - met.z_mm) : FaceProfile::kEndRadius_mm);
  }
  return missed;
}

void Equilibrium::advance(const Load& load, const Vector& step) {
  for (std::size_t n = 0; n < body_.cells.size(); ++n) {
    const Cell& cell = body_.cells[n];
    const Tension tension = tensionOf(cell, load.blood, areaOf(cell, state.at));
    const Eigen::Matrix<double, 8, 1> byArea = areaGradient(cell, state.at);
    double change = 0;
    for (int a = 0; a < 4; ++a) change += byArea.segment<2>(2 * a).dot(step.segment<2>(2 * cell.node[a]));
    state.tension[n] = tension.value + tension.slope * change;
  }
  state.at += step;
}

Equilibrium::Outcome Equilibrium::solve(Load& load, double force_kPa_mm, double tolerance_mm, int maxIterations) {
  Outcome out;
  if (load.meeting.size() == 0) load.meeting = state.at;
  if (force_kPa_mm > 0) load.shift_mm = state.shift_mm;
  int cautious = 0;
  for (; out.iterations < maxIterations && !out.converged; ++out.iterations) {
    if (!factor(load, cautious > 0)) {
      if (cautious > 0) return out;
      cautious = kCautiousRounds + 1;
      continue;
    }
    Vector step = solveWith(-gradientOf(body_, state.at, load));
    const double change = force_kPa_mm > 0 ? followForce(load, force_kPa_mm, step) : 0;
    const double longest = std::max(step.cwiseAbs().maxCoeff(), std::abs(change));
    if (!std::isfinite(longest)) return out;
    const double share = allowedShare(step);
    advance(load, share * step);
    load.shift_mm += share * change;
    out.converged = share == 1 && longest < tolerance_mm && cautious == 0;
    cautious = std::max(cautious - 1, 0);
  }
  if (load.face) out.missed_mm = missedBy(load);
  state.shift_mm = load.shift_mm;
  return out;
}

bool Equilibrium::inOrder() const {
  if (!state.at.allFinite()) return false;
  return std::all_of(body_.cells.begin(), body_.cells.end(),
                     [&](const Cell& cell) { return cell.artery + cell.vein > 0 || areaOf(cell, state.at) > 0; });
}

}  // namespace insonate::reference
