#include "model/Scatterers.h"

#include <insonate/core/Hash.h>

#include <cmath>
#include <numbers>

namespace insonate {
namespace {

/// Faces, edges and corners of a cube, one of each opposite pair. The cube is oblique in the patient; otherwise an
/// axial slice would lie in one plane of the lattice and have the speckle level of that plane.
std::array<Vec3, 13> orientations() {
  const Vec3 axis = normalized({1, 2, 3});
  const double angle = 0.2, c = std::cos(angle), s = std::sin(angle);
  std::array<Vec3, 13> axes;
  std::size_t count = 0;
  for (int x = 0; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && (y < 0 || (y == 0 && z <= 0))) continue;
        const Vec3 v = normalized({double(x), double(y), double(z)});
        axes[count++] = v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));  // Rodrigues' rotation
      }
  return axes;
}

/// Corners of the tetrahedron that contains a lattice point, and their weights, with unit power.
struct Tetrahedron {
  std::array<std::array<int, 3>, 4> node;
  std::array<double, 4> weight;
};

Tetrahedron tetrahedronAt(Vec3 p) {
  const std::array<int, 3> low{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)),
                               static_cast<int>(std::floor(p.z))};
  const std::array<double, 3> f{p.x - low[0], p.y - low[1], p.z - low[2]};
  // The path from the low to the high corner of the cell, largest fraction first.
  const bool xy = f[0] >= f[1], yz = f[1] >= f[2], xz = f[0] >= f[2];
  const std::array<int, 3> rank{(xy ? 0 : 1) + (xz ? 0 : 1), (xy ? 1 : 0) + (yz ? 0 : 1), (xz ? 1 : 0) + (yz ? 1 : 0)};
  std::array<double, 3> sorted{};
  for (int a = 0; a < 3; ++a) sorted[rank[a]] = f[a];
  Tetrahedron t{{}, {1 - sorted[0], sorted[0] - sorted[1], sorted[1] - sorted[2], sorted[2]}};
  double power = 0;
  for (const double w : t.weight) power += w * w;
  for (int corner = 0; corner < 4; ++corner) {
    t.weight[corner] /= std::sqrt(power);
    for (int a = 0; a < 3; ++a) t.node[corner][a] = low[a] + (rank[a] < corner ? 1 : 0);
  }
  return t;
}

double sharedWeight(const Tetrahedron& a, const Tetrahedron& b) {
  double sum = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (a.node[i] == b.node[j]) sum += a.weight[i] * b.weight[j];
  return sum;
}

/// Correlation on a grid of lags, by sampling phases and directions with a low-discrepancy sequence.
struct CorrelationTable {
  static constexpr double kStep = 0.1;
  static constexpr int kSize = 31;
  static constexpr int kSamples = 400;
  std::array<std::array<double, kSize>, kSize> value{};  ///< [elevation][lateral]

  CorrelationTable() {
    for (int n = 0; n < kSamples; ++n) {
      // Roots of x^5 = x + 1 give the steps of an additive recurrence in four dimensions (M. Roberts, 2018).
      constexpr double kRoot = 1.1673039782614187;
      std::array<double, 4> u;
      double step = 1;
      for (double& v : u) step /= kRoot, v = std::fmod(0.5 + step * n, 1.0);
      const Vec3 p{u[0], u[1], u[2]};
      const Tetrahedron here = tetrahedronAt(p);
      const double angle = 2 * std::numbers::pi * u[3], c = std::cos(angle), s = std::sin(angle);
      for (int e = 0; e < kSize; ++e)
        for (int a = 0; a < kSize; ++a)
          value[e][a] +=
              sharedWeight(here, tetrahedronAt(p + Vec3{c * a * kStep, s * a * kStep, e * kStep})) / kSamples;
    }
  }
};

}  // namespace

ScattererLattice::ScattererLattice(Vec3 elevation, double pitch_mm, double elevationPitch_mm, std::uint32_t pattern) {
  Vec3 axis{0, 0, 1};
  double best = -1;
  std::uint32_t index = 0;
  for (const Vec3& candidate : orientations()) {
    ++index;
    const double alignment = std::abs(dot(candidate, elevation));
    if (alignment > best + 1e-9) best = alignment, axis = candidate, seed = index * 0x9e3779b9U;
  }
  seed ^= pattern;
  const Vec3 helper = std::abs(axis.x) < 0.8 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 first = normalized(cross(helper, axis));
  const Vec3 second = cross(axis, first);
  latticeFromPatient = transposed({{first / pitch_mm, second / pitch_mm, axis / elevationPitch_mm}});
}

std::array<double, 6> scattererAmplitudes(const ScattererLattice& lattice, Vec3 patient_mm) {
  const Tetrahedron t = tetrahedronAt(lattice.latticeFromPatient * patient_mm);
  std::array<double, 6> sum{};
  for (int corner = 0; corner < 4; ++corner) {
    const auto& [i, j, k] = t.node[corner];
    const std::uint32_t h = hashNode(i, j, k, lattice.seed);
    for (int c = 0; c < 6; ++c)
      sum[c] += t.weight[corner] * kScattererUnit * ((h >> kScattererShift[c] & 31U) - kScattererMean);
  }
  return sum;
}

double latticeCorrelation(double across_pitches, double elevation_pitches) {
  static const CorrelationTable table;
  const double a = across_pitches / CorrelationTable::kStep, e = elevation_pitches / CorrelationTable::kStep;
  const int a0 = static_cast<int>(a), e0 = static_cast<int>(e);
  if (a0 + 1 >= CorrelationTable::kSize || e0 + 1 >= CorrelationTable::kSize) return 0;
  const auto along = [&](const auto& row) { return row[a0] + (a - a0) * (row[a0 + 1] - row[a0]); };
  return along(table.value[e0]) + (e - e0) * (along(table.value[e0 + 1]) - along(table.value[e0]));
}

}  // namespace insonate
