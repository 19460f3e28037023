#include "sheet/BodyNet.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <utility>

namespace insonate::camera {
namespace {

using Point = BodyNet::Point;

/// Rotation and shift in the plane.
struct PlaneMove {
  double c = 1, s = 0, x = 0, y = 0;
  Point operator()(Point p) const { return {c * p.x - s * p.y + x, s * p.x + c * p.y + y}; }
};

/// A face in a plane of its own.
struct FlatFace {
  Vec3 origin, x, y;
  std::vector<int> vertices;
  std::vector<Point> corners;
  Point flat(Vec3 p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
};

FlatFace flatFace(const TagBody& body, int face) {
  const std::vector<Vec3> corners = cornersOf(body, face);
  const Vec3 z = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
  FlatFace flat{corners[0], normalized(corners[1] - corners[0]), {}, body.faces[std::size_t(face)], {}};
  flat.y = cross(z, flat.x);
  for (const Vec3& corner : corners) flat.corners.push_back(flat.flat(corner));
  return flat;
}

using EdgeOwners = std::map<std::pair<int, int>, int>;  // face of each directed edge

std::vector<int> neighborsOf(const TagBody& body, const EdgeOwners& owners, int face) {
  std::vector<int> neighbors;
  const auto& vertices = body.faces[std::size_t(face)];
  for (std::size_t i = 0; i < vertices.size(); ++i)
    neighbors.push_back(owners.at({vertices[(i + 1) % vertices.size()], vertices[i]}));
  return neighbors;
}

/// Parent of each face in the tree of folds; -1 for the first face.
std::vector<int> foldTree(const TagBody& body, const std::vector<FlatFace>& faces, const EdgeOwners& owners) {
  const auto normal = [&](int f) { return cross(faces[std::size_t(f)].x, faces[std::size_t(f)].y); };
  int opposite = 0;
  for (int f = 0; f < int(faces.size()); ++f)
    if (dot(normal(f), normal(0)) < dot(normal(opposite), normal(0))) opposite = f;
  std::vector<int> parent(faces.size(), -2), flower(faces.size(), -1);
  parent[0] = -1, flower[0] = 0;
  std::deque<int> waiting{0};
  if (opposite != 0) flower[std::size_t(opposite)] = 1, waiting.push_back(opposite);
  std::vector<std::pair<int, int>> inner;  // folds inside the second flower, parent first
  while (!waiting.empty()) {
    const int f = waiting.front();
    waiting.pop_front();
    for (const int n : neighborsOf(body, owners, f)) {
      if (flower[std::size_t(n)] >= 0) continue;
      flower[std::size_t(n)] = flower[std::size_t(f)];
      if (flower[std::size_t(n)] == 0) parent[std::size_t(n)] = f;
      if (flower[std::size_t(n)] == 1) inner.emplace_back(f, n);
      waiting.push_back(n);
    }
  }
  if (opposite == 0) return parent;
  // The bridge joins a leaf of each flower; the folds from the bridge to the middle of the second flower are reversed.
  for (int f = int(faces.size()) - 1; f >= 0; --f) {
    if (flower[std::size_t(f)] != 0) continue;
    for (const int n : neighborsOf(body, owners, f)) {
      if (flower[std::size_t(n)] != 1) continue;
      for (const auto& [a, b] : inner) parent[std::size_t(b)] = a;
      int child = n, next = f;
      while (child >= 0) {
        const int former = child == opposite ? -1 : parent[std::size_t(child)];
        parent[std::size_t(child)] = next;
        next = child, child = former;
      }
      return parent;
    }
  }
  return parent;
}

/// Moves a face so that its edge coincides with the same edge of its parent.
PlaneMove moveOnto(const FlatFace& child, const FlatFace& parent, const PlaneMove& parentMove) {
  const std::size_t count = child.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const int a = child.vertices[i], b = child.vertices[(i + 1) % count];
    for (std::size_t j = 0; j < parent.vertices.size(); ++j) {
      const std::size_t k = (j + 1) % parent.vertices.size();
      if (parent.vertices[j] != b || parent.vertices[k] != a) continue;
      const Point pa = parentMove(parent.corners[k]), pb = parentMove(parent.corners[j]);
      const Point ca = child.corners[i], cb = child.corners[(i + 1) % count];
      const double turn = std::atan2(pb.y - pa.y, pb.x - pa.x) - std::atan2(cb.y - ca.y, cb.x - ca.x);
      PlaneMove move{std::cos(turn), std::sin(turn), 0, 0};
      const Point at = move(ca);
      move.x = pa.x - at.x, move.y = pa.y - at.y;
      return move;
    }
  }
  return parentMove;
}

void addFace(BodyNet& net, const TagBody& body, int face, const FlatFace& flat, const PlaneMove& move) {
  bool hasTag = false;
  for (const BodyTag& tag : body.tags) {
    if (tag.face != face) continue;
    hasTag = true;
    BodyNet::Tag printed{tag.id, {}};
    const auto corners = cornersOf(tag);
    for (std::size_t i = 0; i < 4; ++i) printed.corners[i] = move(flat.flat(tag.bodyFromTag * corners[i]));
    net.tags.push_back(printed);
  }
  if (hasTag) return;
  Point middle;
  for (const Point& corner : flat.corners) middle.x += corner.x, middle.y += corner.y;
  net.handles.push_back(move({middle.x / double(flat.corners.size()), middle.y / double(flat.corners.size())}));
}

}  // namespace

BodyNet unfolded(const TagBody& body) {
  std::vector<FlatFace> faces;
  EdgeOwners owners;
  for (int f = 0; f < int(body.faces.size()); ++f) {
    faces.push_back(flatFace(body, f));
    const auto& vertices = faces.back().vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) owners[{vertices[i], vertices[(i + 1) % vertices.size()]}] = f;
  }
  const std::vector<int> parent = foldTree(body, faces, owners);
  std::vector<PlaneMove> moves(faces.size());
  std::vector<bool> isPlaced(faces.size());
  isPlaced[0] = true;
  for (std::size_t pass = 0; pass < faces.size(); ++pass)
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (isPlaced[f] || parent[f] < 0 || !isPlaced[std::size_t(parent[f])]) continue;
      moves[f] = moveOnto(faces[f], faces[std::size_t(parent[f])], moves[std::size_t(parent[f])]);
      isPlaced[f] = true;
    }
  BodyNet net;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    addFace(net, body, int(f), faces[f], moves[f]);
    const auto& vertices = faces[f].vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::size_t k = (i + 1) % vertices.size();
      const int other = owners.at({vertices[k], vertices[i]});
      const bool isFold = parent[f] == other || parent[std::size_t(other)] == int(f);
      if (isFold && int(f) > other) continue;
      net.edges.push_back(
          {moves[f](faces[f].corners[i]), moves[f](faces[f].corners[k]), isFold, !isFold && int(f) < other});
    }
  }
  return net;
}

BodyNet turned(BodyNet net, double angle) {
  const PlaneMove move{std::cos(angle), std::sin(angle), 0, 0};
  for (auto& edge : net.edges) edge.from = move(edge.from), edge.to = move(edge.to);
  for (auto& tag : net.tags)
    for (auto& corner : tag.corners) corner = move(corner);
  for (auto& handle : net.handles) handle = move(handle);
  return net;
}

}  // namespace insonate::camera
