#include "HeartAnatomy.h"
#include "WallGrid.h"

#include <insonate/cases/VesselName.h>
#include <insonate/tissue/Labels.h>
#include <insonate/wire/VesselTree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace insonate {
namespace {

constexpr double kNear_mm = 3;     // ends up to this distance from another vessel's wall are joined
constexpr double kPiece_mm = 2;    // center lines are sampled at this distance
constexpr double kOnward_mm = 80;  // length of large vessels beyond the case's edge; our choice
constexpr double kLargeRadius_mm = 2.5, kLeastRadius_mm = 0.1;

/// Samples a course with Catmull-Rom splines, since a wire along the wall would feel the corners of a polyline.
std::vector<NamedVessel::Point> smoothed(const std::vector<NamedVessel::Point>& course) {
  std::vector<NamedVessel::Point> fine;
  const auto at = [&](std::ptrdiff_t i) { return course[std::clamp<std::ptrdiff_t>(i, 0, std::ssize(course) - 1)]; };
  for (std::ptrdiff_t i = 0; i + 1 < std::ssize(course); ++i) {
    const auto a = at(i), b = at(i + 1);
    const Vec3 chord = b.position_mm - a.position_mm;
    const double length_mm = norm(chord);
    if (!(length_mm > 0)) continue;
    const auto tangent = [&](std::ptrdiff_t k) {
      const Vec3 across = at(k + 1).position_mm - at(k - 1).position_mm;
      return norm(across) > 0 ? normalized(across) * length_mm : chord;
    };
    const Vec3 ta = tangent(i), tb = tangent(i + 1);
    const int pieces = std::max(1, static_cast<int>(std::lround(length_mm / kPiece_mm)));
    for (int k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, u = 1 - t;
      fine.push_back({a.position_mm * (u * u * (1 + 2 * t)) + ta * (t * u * u) + b.position_mm * (t * t * (3 - 2 * t)) -
                          tb * (t * t * u),
                      a.radius_mm + (b.radius_mm - a.radius_mm) * t});
    }
  }
  if (!course.empty()) fine.push_back(course.back());
  for (NamedVessel::Point& point : fine) point.radius_mm = std::max(point.radius_mm, kLeastRadius_mm);
  return fine;
}

/// The point of another vessel's center line nearest to the end of a vessel, by its wall.
struct Joint {
  int vessel = -1;
  std::size_t point = 0;
  double distance_mm = std::numeric_limits<double>::infinity();
};

Joint jointOf(std::span<const VesselTree::Vessel> vessels, int self, Vec3 end_mm) {
  Joint joint;
  for (int v = 0; v < static_cast<int>(vessels.size()); ++v) {
    const NamedVessel& other = vessels[v].tube;
    if (v == self || other.label != vessels[self].tube.label) continue;
    for (std::size_t i = 0; i < other.course.size(); ++i) {
      const double distance_mm = norm(other.course[i].position_mm - end_mm) - other.course[i].radius_mm;
      if (distance_mm < joint.distance_mm) joint = {v, i, distance_mm};
    }
  }
  return joint;
}

bool isLarge(const NamedVessel& vessel) {
  return vessel.course.back().radius_mm >= kLargeRadius_mm || vessel.course.front().radius_mm >= kLargeRadius_mm;
}

struct Edge {
  int to;
  double length_mm;
};

}  // namespace

struct VesselTree::Data {
  std::vector<Vessel> vessels;
  std::vector<std::vector<wire::Section>> sections;  ///< [vessel][point]; empty: round
  wire::WallGrid veins{{}}, arteries{{}};
  std::vector<int> firstPoint;           ///< [vessel]: index of its first point among the points of all vessels
  std::vector<double> toHeart_mm;        ///< [point]
  std::vector<std::vector<Edge>> edges;  ///< [point]

  void join();
  void addPieces();
  void measureToHeart(const wire::HeartAnatomy& heart);
  const wire::WallGrid& grid(std::uint8_t label) const { return label == kArtery ? arteries : veins; }
};

/// Joins the ends of vessels to other vessels, and continues large vessels that end at the edge of the case.
void VesselTree::Data::join() {
  struct Link {
    int vessel;
    bool last;
    Joint joint;
  };
  std::vector<Link> links;
  for (int v = 0; v < static_cast<int>(vessels.size()); ++v)
    for (const bool last : {false, true}) {
      const wire::TubeEnd end = wire::endOf(vessels[v].tube, last);
      const Joint joint = jointOf(vessels, v, end.at_mm);
      if (joint.distance_mm <= kNear_mm) {
        auto& course = vessels[v].tube.course;
        const NamedVessel::Point bridge{vessels[joint.vessel].tube.course[joint.point].position_mm, end.radius_mm};
        if (joint.distance_mm > -end.radius_mm / 2) {
          course.insert(last ? course.end() : course.begin(), bridge);
          for (Link& link : links)
            if (!last && link.joint.vessel == v) ++link.joint.point;
          if (v < static_cast<int>(sections.size()) && !sections[v].empty())
            sections[v].insert(last ? sections[v].end() : sections[v].begin(), wire::roundSection(end.radius_mm));
        }
        links.push_back({v, last, joint});
      } else if (!vessels[v].beyondCase && isLarge(vessels[v].tube)) {
        Vessel onward{{vessels[v].tube.name, vessels[v].tube.label, {}}, true};  // is joined in its turn
        for (double s = 0; s <= kOnward_mm; s += kPiece_mm) {
          const Vec3 at_mm = end.at_mm + end.outward * s;
          if (jointOf(vessels, v, at_mm).distance_mm < end.radius_mm + kNear_mm) break;  // into another vessel
          onward.tube.course.push_back({at_mm, end.radius_mm});
        }
        if (onward.tube.course.size() > 1) vessels.push_back(std::move(onward));
      }
    }
  firstPoint.clear();
  int points = 0;
  for (const Vessel& vessel : vessels) {
    firstPoint.push_back(points);
    points += static_cast<int>(vessel.tube.course.size());
  }
  edges.resize(points);
  const auto link = [&](int a, int b, double length_mm) {
    edges[a].push_back({b, length_mm});
    edges[b].push_back({a, length_mm});
  };
  for (std::size_t v = 0; v < vessels.size(); ++v) {
    const auto& course = vessels[v].tube.course;
    for (std::size_t i = 1; i < course.size(); ++i)
      link(firstPoint[v] + int(i) - 1, firstPoint[v] + int(i), norm(course[i].position_mm - course[i - 1].position_mm));
  }
  for (const Link& l : links) {
    const auto& course = vessels[l.vessel].tube.course;
    const std::size_t end = l.last ? course.size() - 1 : 0;
    const auto& to = vessels[l.joint.vessel].tube.course[l.joint.point];
    link(firstPoint[l.vessel] + int(end), firstPoint[l.joint.vessel] + int(l.joint.point),
         norm(to.position_mm - course[end].position_mm));
  }
}

void VesselTree::Data::addPieces() {
  std::vector<wire::TubePiece> pieces[2];
  for (int v = 0; v < static_cast<int>(vessels.size()); ++v) {
    const auto& course = vessels[v].tube.course;
    const bool isMeasured = v < static_cast<int>(sections.size()) && !sections[v].empty();
    double start_mm = 0;
    for (std::size_t i = 1; i < course.size(); ++i) {
      const NamedVessel::Point &a = course[i - 1], &b = course[i];
      const Vec3 along = b.position_mm - a.position_mm;
      const double length_mm = norm(along);
      if (!(length_mm > 0)) continue;
      wire::TubePiece piece{
          a.position_mm, along / length_mm,         length_mm, a.radius_mm, (b.radius_mm - a.radius_mm) / length_mm, v,
          start_mm,      firstPoint[v] + int(i) - 1};
      if (isMeasured) {
        piece.isRound = false;
        piece.section = sections[v][i - 1];
        for (std::size_t k = 0; k < piece.section.size(); ++k)
          piece.change[k] = (sections[v][i][k] - sections[v][i - 1][k]) / length_mm;
      }
      pieces[vessels[v].tube.label == kArtery].push_back(piece);
      start_mm += length_mm;
    }
  }
  veins = wire::WallGrid(std::move(pieces[0]));
  arteries = wire::WallGrid(std::move(pieces[1]));
}

/// Shortest paths along the center lines (Dijkstra). Beyond the junction with the heart, distances are negative.
void VesselTree::Data::measureToHeart(const wire::HeartAnatomy& heart) {
  toHeart_mm.assign(edges.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<const NamedVessel::Point*> points;
  for (const Vessel& vessel : vessels)
    for (const auto& point : vessel.tube.course) points.push_back(&point);
  for (const auto& junction : {heart.veinsToHeart, heart.arteriesToHeart}) {
    if (!junction) continue;
    using Step = std::pair<double, int>;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
    for (int p = 0; p < static_cast<int>(points.size()); ++p)
      if (norm(points[p]->position_mm - *junction) < 1e-6) open.emplace(0.0, p);
    while (!open.empty()) {
      const auto [length_mm, p] = open.top();
      open.pop();
      if (toHeart_mm[p] <= length_mm) continue;
      toHeart_mm[p] = length_mm;
      for (const Edge& edge : edges[p]) open.emplace(length_mm + edge.length_mm, edge.to);
    }
  }
  for (std::size_t v = 0; v < vessels.size(); ++v)
    if (vessels[v].isBeyondHeart)
      for (std::size_t i = 0; i < vessels[v].tube.course.size(); ++i) toHeart_mm[firstPoint[v] + i] *= -1;
}

Result<VesselTree> VesselTree::make(std::span<const NamedVessel> vessels, const LabelMap* labels) {
  auto data = std::make_shared<Data>();
  std::vector<NamedVessel> tubes;
  for (const NamedVessel& vessel : vessels) {
    if (vessel.label != kVein && vessel.label != kArtery) continue;
    auto course = smoothed(vessel.course);
    if (course.size() > 1) tubes.push_back({vessel.name, vessel.label, std::move(course)});
  }
  if (tubes.empty())
    return fail(
        "The case names no vein and no artery, so that a wire has no vessel to follow. Name the vessels in "
        "Prepare.");
  for (NamedVessel& tube : tubes)
    if (labels) data->sections.push_back(wire::measuredSections(tube, *labels));
  const wire::HeartAnatomy heart = wire::heartAnatomy(tubes);
  for (NamedVessel& tube : tubes) data->vessels.push_back({std::move(tube), false, false});
  for (const NamedVessel& tube : heart.vessels) data->vessels.push_back({tube, true, false});
  for (const NamedVessel& tube : heart.beyond) data->vessels.push_back({tube, true, true});
  data->join();
  data->addPieces();
  data->measureToHeart(heart);
  VesselTree tree;
  tree.data_ = std::move(data);
  return tree;
}

std::span<const VesselTree::Vessel> VesselTree::vessels() const {
  return data_->vessels;
}

VesselTree::Wall VesselTree::wallAt(std::uint8_t label, Vec3 patient_mm) const noexcept {
  const wire::WallGrid& grid = data_->grid(label);
  wire::TubePiece::Nearest nearest{};
  const int found = grid.find(patient_mm, nearest);
  if (found < 0) return {std::numeric_limits<double>::infinity(), {}, {0, 0, 1}, 0};
  const wire::TubePiece& piece = grid.pieces()[found];
  return {nearest.distance_mm, piece.outward(nearest), piece.along, piece.curvature_1pmm(nearest)};
}

/// In the lumen of several tubes, the tube whose center is nearest in relation to its radius counts. The tube with the
/// farthest wall would be the atrium long before a wire gets there.
VesselTree::Location VesselTree::locate(std::uint8_t label, Vec3 patient_mm) const noexcept {
  const std::span<const wire::TubePiece> pieces = data_->grid(label).pieces();
  const wire::TubePiece* found = nullptr;
  wire::TubePiece::Nearest at{};
  double least = std::numeric_limits<double>::infinity();
  bool isInside = false;
  for (const wire::TubePiece& piece : pieces) {
    const auto nearest = piece.nearest(patient_mm);
    const bool inside = nearest.distance_mm < 0;
    if (isInside && !inside) continue;
    const double rank = inside ? nearest.relative : nearest.distance_mm;
    if (isInside == inside && rank >= least) continue;
    found = &piece, at = nearest, least = rank, isInside = inside;
  }
  if (!found) return {.distance_mm = std::numeric_limits<double>::infinity()};
  const double a_mm = data_->toHeart_mm[found->point], b_mm = data_->toHeart_mm[found->point + 1];
  Vec3 towardHeart{};
  if (std::isfinite(a_mm) && std::isfinite(b_mm))
    towardHeart = std::abs(b_mm) < std::abs(a_mm) ? found->along : -found->along;
  return {found->vessel, found->start_mm + at.t_mm, wallAt(label, patient_mm).distance_mm,
          a_mm + (b_mm - a_mm) * at.t_mm / found->length_mm, towardHeart};
}

std::uint8_t VesselTree::systemAt(Vec3 patient_mm) const noexcept {
  const auto distance_mm = [&](std::uint8_t label) { return wallAt(label, patient_mm).distance_mm; };
  return distance_mm(kArtery) < distance_mm(kVein) ? kArtery : kVein;
}

}  // namespace insonate
