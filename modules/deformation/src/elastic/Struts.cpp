#include "elastic/Struts.h"

#include <algorithm>

namespace insonate::elastic {

void Struts::prepare(const Mesh& mesh, const Materials& materials) {
  down_.clear();
  across_.clear();
  if (!materials.anyBlood) return;
  const int nx = mesh.columns();
  const Nodes& rest = mesh.rest();
  const auto blood = [&](int n) { return std::max(materials.arteryBlood[n], materials.veinBlood[n]); };
  for (int j = 1; j + 1 < mesh.rows(); ++j)
    for (int i = 1; i + 1 < nx; ++i) {
      const int n = j * nx + i;
      const float below = (blood(n) + blood(n - 1)) / 2, right = (blood(n) + blood(n - nx)) / 2;
      if (below > 0.25f) down_.push_back({n, n + nx, kLeft * (rest.z[n + nx] - rest.z[n]), below * kStiffness_kPa});
      if (right > 0.25f) across_.push_back({n, n + 1, kLeft * (rest.x[n + 1] - rest.x[n]), right * kStiffness_kPa});
    }
}

void Struts::add(const Nodes& at, GridMatrix& matrix, std::vector<float>& force) const {
  for (const Strut& s : down_) {
    const float missing = s.min_mm - (at.z[s.to] - at.z[s.from]);
    if (missing <= 0) continue;
    force[2 * s.from + 1] -= s.stiffness_kPa * missing;
    force[2 * s.to + 1] += s.stiffness_kPa * missing;
    matrix.value[2][s.from] += s.stiffness_kPa;
    matrix.value[2][s.to] += s.stiffness_kPa;
    matrix.value[GridMatrix::first(GridMatrix::South) + 3][s.from] -= s.stiffness_kPa;
  }
  for (const Strut& s : across_) {
    const float missing = s.min_mm - (at.x[s.to] - at.x[s.from]);
    if (missing <= 0) continue;
    force[2 * s.from] -= s.stiffness_kPa * missing;
    force[2 * s.to] += s.stiffness_kPa * missing;
    matrix.value[0][s.from] += s.stiffness_kPa;
    matrix.value[0][s.to] += s.stiffness_kPa;
    matrix.value[GridMatrix::first(GridMatrix::East)][s.from] -= s.stiffness_kPa;
  }
}

}  // namespace insonate::elastic
