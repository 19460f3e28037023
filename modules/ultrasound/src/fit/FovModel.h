#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <array>
#include <vector>

namespace insonate::fit {

enum Edge { kLeft, kRight, kFace, kDeep, kEdges };

/// A fan or rectangle that opens downward, in pixels of the searched image. `turn` is the angle of its axis from
/// vertical, positive toward the right; `half` is half the fan's angle (radians) or half the rectangle's width.
struct FovModel {
  bool fan = true;
  double x = 0, y = 0, turn = 0, half = 0.5, inner = 0, outer = 100;

  /// Returns the signed distance by which a point lies beyond each edge; all are negative if the point is inside.
  std::array<double, kEdges> beyond(PixelPoint p) const;
  /// Returns a point of the field of view; `across` is -1 (left) to 1 (right), `down` is 0 (face) to 1 (far end).
  PixelPoint at(double across, double down) const;
  double area() const;
};

/// Computes FovModel::beyond() quickly for many points of one model.
class Beyond {
 public:
  explicit Beyond(const FovModel& model);
  std::array<double, kEdges> operator()(PixelPoint p) const;
  bool inside(PixelPoint p) const;

 private:
  const FovModel& model_;
  double cosTurn_, sinTurn_, cosHalf_, sinHalf_;
};

struct EdgeSample {
  PixelPoint at, outward;  ///< at: point on an edge; outward: unit vector perpendicular to the edge
  Edge edge = kLeft;
};

/// Returns points on the model's outline about `step_px` apart; a face that is a single point has none.
std::vector<EdgeSample> edgeSamples(const FovModel& model, double step_px);

/// parameters() returns the number of parameters of a model, parameter() gives access to them by index: x, y, turn,
/// half, outer, and, for fans, inner.
int parameters(const FovModel& model);
double& parameter(FovModel& model, int index);

}  // namespace insonate::fit
