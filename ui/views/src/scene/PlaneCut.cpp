#include "PlaneCut.h"

#include <algorithm>
#include <cmath>

namespace insonate::views {
namespace {

/// The inside is filled in strips: their minimum height, and their maximum number.
constexpr double kMinStrip_mm = 0.25;
constexpr double kMaxStrips = 500;

}  // namespace

double PlaneCut::Edge::acrossAt(double up) const {
  const double height = high.up - low.up;
  const double share = height > 0 ? std::clamp((up - low.up) / height, 0.0, 1.0) : 0;
  return low.across + (high.across - low.across) * share;
}

void PlaneCut::clear() {
  points_mm_.clear(), triangles_.clear(), outline_.clear(), edges_.clear();
}

void PlaneCut::cut(const Surface& surface, const ClippingPlane& plane) {
  clear();
  origin_mm_ = plane.point_mm;
  const Vec3 n = normalized(plane.normal);
  across_ = normalized(cross(std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{0, 1, 0}, n));
  up_ = cross(n, across_);
  findEdges(surface, plane);
  for (const Edge& edge : edges_)
    for (const Place& end : {edge.low, edge.high}) outline_.push_back(add(end));
  fill();
}

std::uint32_t PlaneCut::add(Place place) {
  const Vec3 at = origin_mm_ + across_ * place.across + up_ * place.up;
  for (int axis = 0; axis < 3; ++axis) points_mm_.push_back(float(at[axis]));
  return std::uint32_t(points_mm_.size() / 3 - 1);
}

void PlaneCut::findEdges(const Surface& surface, const ClippingPlane& plane) {
  const auto point = [&](std::uint32_t k) {
    const float* at = surface.points_mm.data() + 3 * std::size_t(k);
    return Vec3{at[0], at[1], at[2]};
  };
  distances_.resize(surface.points_mm.size() / 3);
  for (std::size_t k = 0; k < distances_.size(); ++k)
    distances_[k] = float(dot(point(std::uint32_t(k)) - plane.point_mm, plane.normal));
  // Equal for both triangles of an edge, so that the outline is closed.
  const auto crossing = [&](std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const double share = distances_[a] / (double(distances_[a]) - distances_[b]);
    const Vec3 at = point(a) + (point(b) - point(a)) * share - origin_mm_;
    return Place{dot(at, across_), dot(at, up_)};
  };
  for (std::size_t k = 0; k + 2 < surface.triangles.size(); k += 3) {
    const std::uint32_t* corner = surface.triangles.data() + k;
    const bool kept[] = {distances_[corner[0]] >= 0, distances_[corner[1]] >= 0, distances_[corner[2]] >= 0};
    if (kept[0] == kept[1] && kept[1] == kept[2]) continue;
    // The corner that is alone on its side of the plane.
    const int alone = kept[1] == kept[2] ? 0 : kept[0] == kept[2] ? 1 : 2;
    Edge edge{crossing(corner[alone], corner[(alone + 1) % 3]), crossing(corner[alone], corner[(alone + 2) % 3])};
    if (edge.low.up > edge.high.up) std::swap(edge.low, edge.high);
    edges_.push_back(edge);
  }
  std::ranges::sort(edges_, {}, [](const Edge& edge) { return edge.low.up; });
}

void PlaneCut::fill() {
  if (edges_.empty()) return;
  levels_.clear();
  for (const Edge& edge : edges_) levels_.push_back(edge.low.up), levels_.push_back(edge.high.up);
  std::ranges::sort(levels_);
  const double least = std::max(kMinStrip_mm, (levels_.back() - levels_.front()) / kMaxStrips);
  active_.clear();
  auto next = edges_.begin();
  double low = levels_.front();
  for (const double high : levels_) {
    if (high - low < least && high != levels_.back()) continue;
    if (high <= low) continue;
    const double middle = (low + high) / 2;
    for (; next != edges_.end() && next->low.up <= middle; ++next) active_.push_back(&*next);
    std::erase_if(active_, [&](const Edge* edge) { return edge->high.up <= middle; });
    fillStrip(low, high);
    low = high;
  }
}

/// Inside is between the first and the second edge, the third and the fourth, and so on.
void PlaneCut::fillStrip(double low, double high) {
  // If the surface has a hole, inside and outside are undefined here.
  if (active_.size() % 2 != 0) return;
  const double middle = (low + high) / 2;
  std::ranges::sort(active_, {}, [&](const Edge* edge) { return edge->acrossAt(middle); });
  for (std::size_t k = 0; k + 1 < active_.size(); k += 2) {
    const Edge &left = *active_[k], &right = *active_[k + 1];
    const std::uint32_t a = add({left.acrossAt(low), low}), b = add({right.acrossAt(low), low});
    const std::uint32_t c = add({right.acrossAt(high), high}), d = add({left.acrossAt(high), high});
    for (const std::uint32_t corner : {a, b, c, a, c, d}) triangles_.push_back(corner);
  }
}

}  // namespace insonate::views
