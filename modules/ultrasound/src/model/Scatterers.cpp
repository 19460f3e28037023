#include "model/Scatterers.h"

#include <insonate/core/Hash.h>

#include <cmath>
#include <vector>

namespace insonate {
namespace {

/// Faces, edges and corners of a cube, one of each opposite pair.
std::vector<Vec3> orientations() {
  std::vector<Vec3> axes;
  for (int x = 0; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && (y < 0 || (y == 0 && z <= 0))) continue;
        axes.push_back(normalized({double(x), double(y), double(z)}));
      }
  return axes;
}

}  // namespace

ScattererLattice::ScattererLattice(Vec3 elevation, double pitch_mm, double elevationPitch_mm) {
  Vec3 axis{0, 0, 1};
  double best = -1;
  std::uint32_t index = 0;
  for (const Vec3& candidate : orientations()) {
    ++index;
    const double alignment = std::abs(dot(candidate, elevation));
    if (alignment > best + 1e-9) best = alignment, axis = candidate, seed = index * 0x9e3779b9U;
  }
  const Vec3 helper = std::abs(axis.x) < 0.8 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 first = normalized(cross(helper, axis));
  const Vec3 second = cross(axis, first);
  latticeFromPatient = transposed({{first / pitch_mm, second / pitch_mm, axis / elevationPitch_mm}});
}

std::array<double, 6> scattererAmplitudes(const ScattererLattice& lattice, Vec3 patient_mm) {
  const Vec3 p = lattice.latticeFromPatient * patient_mm;
  const std::array<int, 3> node{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)),
                                static_cast<int>(std::floor(p.z))};
  const std::array<double, 3> f{p.x - node[0], p.y - node[1], p.z - node[2]};
  // The path from the low to the high corner of the cell, longest fraction first.
  const bool xy = f[0] >= f[1], yz = f[1] >= f[2], xz = f[0] >= f[2];
  const std::array<int, 3> rank{(xy ? 0 : 1) + (xz ? 0 : 1), (xy ? 1 : 0) + (yz ? 0 : 1), (xz ? 1 : 0) + (yz ? 1 : 0)};
  std::array<double, 3> sorted{};
  for (int a = 0; a < 3; ++a) sorted[rank[a]] = f[a];
  const std::array<double, 4> weight{1 - sorted[0], sorted[0] - sorted[1], sorted[1] - sorted[2], sorted[2]};

  std::array<double, 6> sum{};
  double power = 0;
  for (int corner = 0; corner < 4; ++corner) {
    const auto step = [&](int axis) { return node[axis] + (rank[axis] < corner ? 1 : 0); };
    const std::uint32_t h = hashNode(step(0), step(1), step(2), lattice.seed);
    for (int c = 0; c < 6; ++c) sum[c] += weight[corner] * ((h >> (5 * c) & 31U) - kScattererMean);
    power += weight[corner] * weight[corner];
  }
  for (double& v : sum) v *= kScattererUnit / std::sqrt(power);
  return sum;
}

}  // namespace insonate
