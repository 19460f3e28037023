#include "elastic/VesselWall.h"

#include <algorithm>

namespace insonate::elastic {
namespace {

constexpr float kInside = 0.02f, kOutside = 0.98f;  // range of the share of cells on the outline
constexpr std::size_t kMaxPoints = 256;             // maximum number of points of an outline for its mean
constexpr float kMinRadius_mm = 0.5f, kMaxRadius_mm = 20;

}  // namespace

TubeStiffness tubeStiffness(const MechanicalTissue& vessel, const OutlineCurvature& bend) {
  const float both = bend.inPlane_permm + bend.outOfPlane_permm;
  if (both <= 0 || bend.outOfPlane_permm <= 0) return {};
  const float share = std::min(bend.outOfPlane_permm / both, 1.0f);
  const float radius_mm = std::clamp(1 / both, kMinRadius_mm, kMaxRadius_mm);
  constexpr double kPoisson = 0.49;
  const double tube = vessel.wallYoung_kPa / (1 - kPoisson * kPoisson) * vessel.wall_mm / radius_mm;
  const double round = vessel.sheathYoung_kPa / (1 + kPoisson);
  const auto wider = static_cast<float>(share * (tube + round));
  return {wider, std::min(wider, static_cast<float>(share * 3 * std::max(vessel.pressure_kPa, 0.0)))};
}

OutlineCurvature TubeFinder::meanBend(const Mesh& mesh, const TissuePlane& plane, float PlaneTissue::*outline,
                                      const std::vector<float>& shares) {
  const std::size_t nx = mesh.columns();
  const Nodes& rest = mesh.rest();
  points_.clear();
  for (const std::size_t n : part_)
    if (shares[n] > kInside && shares[n] < kOutside)
      points_.push_back({(rest.x[n] + rest.x[n + 1 + nx]) / 2, (rest.z[n] + rest.z[n + 1 + nx]) / 2});
  if (points_.empty()) return {};
  if (const std::size_t step = (points_.size() + kMaxPoints - 1) / kMaxPoints; step > 1) {
    for (std::size_t k = 0; k * step < points_.size(); ++k) points_[k] = points_[k * step];
    points_.resize((points_.size() + step - 1) / step);
  }
  bends_.resize(points_.size());
  plane.sampleCurvature(points_, outline, bends_);
  OutlineCurvature mean;
  for (const OutlineCurvature& b : bends_)
    mean.inPlane_permm += b.inPlane_permm, mean.outOfPlane_permm += b.outOfPlane_permm;
  const auto count = static_cast<float>(points_.size());
  return {std::max(mean.inPlane_permm / count, 0.0f), std::max(mean.outOfPlane_permm / count, 0.0f)};
}

void TubeFinder::find(const Mesh& mesh, const TissuePlane& plane, float PlaneTissue::*outline,
                      const MechanicalTissue& vessel, const std::vector<float>& shares,
                      std::vector<TubeStiffness>& stiffness) {
  const int nx = mesh.columns(), nz = mesh.rows();
  stiffness.assign(shares.size(), {});
  seen_.assign(std::size_t(nx) * nz, 0);
  for (int j = 0; j + 1 < nz; ++j)
    for (int i = 0; i + 1 < nx; ++i) {
      const std::size_t first = std::size_t(j) * nx + i;
      if (seen_[first] || shares[first] <= 0) continue;
      part_.assign(1, first);
      seen_[first] = 1;
      for (std::size_t k = 0; k < part_.size(); ++k) {
        const int ci = static_cast<int>(part_[k] % nx), cj = static_cast<int>(part_[k] / nx);
        for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          if (ci + di < 0 || ci + di + 1 >= nx || cj + dj < 0 || cj + dj + 1 >= nz) continue;
          const std::size_t beside = std::size_t(cj + dj) * nx + (ci + di);
          if (!seen_[beside] && shares[beside] > 0) seen_[beside] = 1, part_.push_back(beside);
        }
      }
      const TubeStiffness tube = tubeStiffness(vessel, meanBend(mesh, plane, outline, shares));
      for (const std::size_t n : part_) stiffness[n] = tube;
    }
}

}  // namespace insonate::elastic
