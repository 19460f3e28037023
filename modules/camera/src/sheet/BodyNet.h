#pragma once

#include <insonate/camera/HandsSheet.h>

#include <vector>

namespace insonate::camera {

/// The surface of a body, unfolded into a plane as seen from outside: x right, y up, mm.
struct BodyNet {
  struct Point {
    double x = 0, y = 0;
  };
  struct Edge {
    Point from, to;
    bool isFold = false;  ///< false: cut
    bool hasTab = false;  ///< a cut edge to which another face is glued
  };
  struct Tag {
    int id = 0;
    std::array<Point, 4> corners;
  };
  std::vector<Edge> edges;
  std::vector<Tag> tags;
  std::vector<Point> handles;  ///< middles of the faces without a tag
};

/// Unfolds a body: the faces around the first face and those around the face opposite to it form two flowers, which are
/// joined at one edge.
BodyNet unfolded(const TagBody& body);

/// Returns the net turned by an angle (rad, counterclockwise).
BodyNet turned(BodyNet net, double angle);

}  // namespace insonate::camera
