#include "elastic/CarryOver.h"

#include <algorithm>

namespace insonate::elastic {
namespace {

constexpr float kAlike = 1.5f;

}

void CarryOver::keep(const Mesh& mesh, const Solver& solver) {
  mesh_.takeShape(mesh);
  at_ = solver.at();
  pressure_ = solver.cellPressure();
  prestress_ = solver.prestress();
  mu_ = solver.elements().mu;
}

Mesh::Place CarryOver::placeOf(const Mesh& mesh, std::size_t node, const Transform& keptFromNow) const {
  const Vec3 was = keptFromNow * Vec3{mesh.rest().x[node], 0, mesh.rest().z[node]};
  return mesh_.placeOf(static_cast<float>(was.x), static_cast<float>(was.z), node);
}

std::size_t CarryOver::cellOf(const Mesh::Place& place, float mu) const {
  const int nx = mesh_.columns();
  const int row = std::min(static_cast<int>(place.row + 0.5f), mesh_.rows() - 2);
  const int column = std::min(static_cast<int>(place.column + 0.5f), nx - 2);
  const auto unlike = [&](std::size_t cell) { return std::max(mu_[cell], mu) / std::min(mu_[cell], mu); };
  std::size_t best = std::size_t(row) * nx + column;
  if (mu <= 0) return best;
  float least = unlike(best);
  if (least < kAlike) return best;
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, mesh_.rows() - 2); ++r)
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, nx - 2); ++c)
      if (const std::size_t cell = std::size_t(r) * nx + c; unlike(cell) < least) least = unlike(cell), best = cell;
  return best;
}

void CarryOver::transferStress(const Mesh& mesh, const Materials& materials, const Transform& keptFromNow,
                               Prestress& prestress) const {
  prestress.xx.resize(prestress_.xx.size());
  prestress.zz.resize(prestress_.xx.size());
  prestress.xz.resize(prestress_.xx.size());
  prestress.volume.resize(prestress_.xx.size());
  for (std::size_t n = 0; n < std::size_t(mesh.columns()) * mesh.rows(); ++n) {
    const std::size_t cell = cellOf(placeOf(mesh, n, keptFromNow), materials.mu[n]);
    prestress.xx[n] = prestress_.xx[cell];
    prestress.zz[n] = prestress_.zz[cell];
    prestress.xz[n] = prestress_.xz[cell];
    prestress.volume[n] = prestress_.volume[cell];
  }
}

void CarryOver::shareSolution(const Mesh& mesh, const Materials& materials, const Transform& keptFromNow,
                              Solver& solver) const {
  const Nodes &rest = mesh.rest(), &restBefore = mesh_.rest();
  const int was = mesh_.columns();
  const Mat3& turn = keptFromNow.linear;
  for (std::size_t n = 0; n < std::size_t(mesh.columns()) * mesh.rows(); ++n) {
    const Mesh::Place place = placeOf(mesh, n, keptFromNow);
    const int c = std::min(static_cast<int>(place.column), was - 2);
    const int r = std::min(static_cast<int>(place.row), mesh_.rows() - 2);
    const std::size_t o = std::size_t(r) * was + c;
    const float u = place.column - c, v = place.row - r;
    const auto blend = [&](const std::vector<float>& now, const std::vector<float>& before) {
      const auto shift = [&](std::size_t k) { return now[k] - before[k]; };
      return (1 - v) * ((1 - u) * shift(o) + u * shift(o + 1)) +
             v * ((1 - u) * shift(o + was) + u * shift(o + was + 1));
    };
    const double x = blend(at_.x, restBefore.x), z = blend(at_.z, restBefore.z);
    solver.at().x[n] = rest.x[n] + static_cast<float>(turn.column[0].x * x + turn.column[0].z * z);
    solver.at().z[n] = rest.z[n] + static_cast<float>(turn.column[2].x * x + turn.column[2].z * z);
    solver.cellPressure()[n] = pressure_[cellOf(place, materials.mu[n])];
  }
  solver.carry();
}

}  // namespace insonate::elastic
