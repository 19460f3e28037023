#include "reference/Equations.h"

#include "elastic/Contact.h"

#include <algorithm>
#include <cmath>

namespace insonate::reference {
namespace {

/// Second derivative of a cell's area with respect to x of one corner and z of another; for z and x it is the negative.
constexpr double kTwist[4][4] = {{0, 0.5, 0, -0.5}, {-0.5, 0, 0.5, 0}, {0, -0.5, 0, 0.5}, {0.5, 0, -0.5, 0}};

double missing(const Strut& strut, const Vector& at) {
  return std::max(0.0, strut.min_mm - (at[2 * strut.to + strut.axis] - at[2 * strut.from + strut.axis]));
}

}  // namespace

double areaOf(const Cell& cell, const Vector& at) {
  const auto x = [&](int corner) { return at[2 * cell.node[corner]]; };
  const auto z = [&](int corner) { return at[2 * cell.node[corner] + 1]; };
  return 0.5 * ((x(2) - x(0)) * (z(3) - z(1)) - (z(2) - z(0)) * (x(3) - x(1)));
}

Eigen::Matrix<double, 8, 1> areaGradient(const Cell& cell, const Vector& at) {
  Eigen::Matrix<double, 8, 1> gradient = Eigen::Matrix<double, 8, 1>::Zero();
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      gradient[2 * a] += kTwist[a][b] * at[2 * cell.node[b] + 1];
      gradient[2 * a + 1] -= kTwist[a][b] * at[2 * cell.node[b]];
    }
  return gradient;
}

Tension tensionOf(const Cell& cell, const BloodPressure& blood, double area_mm2) {
  const double j = area_mm2 / cell.area, below = std::min(j - Cell::kShutBelow, 0.0),
               above = std::max(j - cell.fullAbove, 0.0);
  Tension tension;
  tension.value = cell.initial - blood.artery_kPa * cell.artery - blood.vein_kPa * cell.vein + cell.bulk * (j - 1) +
                  cell.hoop * std::max(j - 1, 0.0) + cell.shut * below + cell.full * above * above;
  tension.slope =
      (cell.bulk + (j > 1 ? cell.hoop : 0) + (below < 0 ? cell.shut : 0) + 2 * cell.full * above) / cell.area;
  return tension;
}

Touch touchOf(const Body& body, const Vector& at, const Load& load, int column) {
  if (!load.face) return {};
  const FaceProfile::Point profile = load.face->at(static_cast<float>(load.meeting[2 * column]));
  const double depth = profile.z_mm + load.shift_mm - at[2 * column + 1];
  if (!profile.under || depth <= 0) return {};
  const double left = body.rest[2 * std::max(column - 1, 0)];
  const double right = body.rest[2 * std::min(column + 1, body.columns - 1)];
  return {elastic::Contact::kStiffness_kPa_mm * (right - left) / 2, depth};
}

double energyOf(const Body& body, const Vector& at, const Load& load) {
  double energy = -body.dead.dot(at);
  for (const Cell& cell : body.cells) {
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        energy += 0.5 * cell.spring(a, b) * at.segment<2>(2 * cell.node[a]).dot(at.segment<2>(2 * cell.node[b]));
    const double area = areaOf(cell, at), j = area / cell.area;
    const double blood = load.blood.artery_kPa * cell.artery + load.blood.vein_kPa * cell.vein;
    energy += (cell.initial - blood) * area + cell.bulk / 2 * cell.area * (j - 1) * (j - 1) +
              cell.hoop / 2 * cell.area * std::pow(std::max(j - 1, 0.0), 2) +
              cell.shut / 2 * cell.area * std::pow(std::min(j - Cell::kShutBelow, 0.0), 2) +
              cell.full / 3 * cell.area * std::pow(std::max(j - cell.fullAbove, 0.0), 3);
  }
  for (const Strut& strut : body.struts) energy += strut.stiffness_kPa / 2 * std::pow(missing(strut, at), 2);
  for (int column = 0; column < body.columns; ++column) {
    const Touch touch = touchOf(body, at, load, column);
    energy += touch.stiffness_kPa / 2 * touch.depth_mm * touch.depth_mm;
  }
  return energy;
}

Vector gradientOf(const Body& body, const Vector& at, const Load& load) {
  Vector gradient = -body.dead;
  for (const Cell& cell : body.cells) {
    const Eigen::Matrix<double, 8, 1> byArea = areaGradient(cell, at);
    const double tension = tensionOf(cell, load.blood, areaOf(cell, at)).value;
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b)
        gradient.segment<2>(2 * cell.node[a]) += cell.spring(a, b) * at.segment<2>(2 * cell.node[b]);
      gradient.segment<2>(2 * cell.node[a]) += tension * byArea.segment<2>(2 * a);
    }
  }
  for (const Strut& strut : body.struts) {
    const double push = strut.stiffness_kPa * missing(strut, at);
    gradient[2 * strut.from + strut.axis] += push;
    gradient[2 * strut.to + strut.axis] -= push;
  }
  for (int column = 0; column < body.columns; ++column) {
    const Touch touch = touchOf(body, at, load, column);
    gradient[2 * column + 1] -= touch.stiffness_kPa * touch.depth_mm;
    if (load.sticking) gradient[2 * column] += touch.stiffness_kPa * (at[2 * column] - body.rest[2 * column]);
  }
  return gradient;
}

double faceForceOf(const Body& body, const Vector& at, const Load& load) {
  double force = 0;
  for (int column = 0; column < body.columns; ++column) {
    const Touch touch = touchOf(body, at, load, column);
    force += touch.stiffness_kPa * touch.depth_mm;
  }
  return force;
}

std::vector<Eigen::Triplet<double>> tangentOf(const Body& body, const Vector& at, const Load& load,
                                              const std::vector<double>& tension, double most) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(64 * body.cells.size());
  for (std::size_t n = 0; n < body.cells.size(); ++n) {
    const Cell& cell = body.cells[n];
    const Eigen::Matrix<double, 8, 1> byArea = areaGradient(cell, at);
    const double slope = tensionOf(cell, load.blood, areaOf(cell, at)).slope;
    const double twist = std::clamp(tension[n], -most * cell.mu, most * cell.mu);
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b) {
        const bool sameAxis = a % 2 == b % 2;
        double value = slope * byArea[a] * byArea[b];
        value += sameAxis ? cell.spring(a / 2, b / 2) : twist * kTwist[a / 2][b / 2] * (a % 2 == 0 ? 1 : -1);
        entries.emplace_back(2 * cell.node[a / 2] + a % 2, 2 * cell.node[b / 2] + b % 2, value);
      }
  }
  for (const Strut& strut : body.struts) {
    if (missing(strut, at) <= 0) continue;
    const int from = 2 * strut.from + strut.axis, to = 2 * strut.to + strut.axis;
    entries.emplace_back(from, from, strut.stiffness_kPa);
    entries.emplace_back(to, to, strut.stiffness_kPa);
    entries.emplace_back(from, to, -strut.stiffness_kPa);
    entries.emplace_back(to, from, -strut.stiffness_kPa);
  }
  for (int column = 0; column < body.columns; ++column) {
    const double stiffness = touchOf(body, at, load, column).stiffness_kPa;
    entries.emplace_back(2 * column + 1, 2 * column + 1, stiffness);
    if (load.sticking) entries.emplace_back(2 * column, 2 * column, stiffness);
  }
  return entries;
}

}  // namespace insonate::reference
