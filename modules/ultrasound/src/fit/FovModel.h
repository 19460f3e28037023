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

  /// Signed distances of a point beyond each edge; all are negative if the point is inside.
  std::array<double, kEdges> beyond(PixelPoint p) const;
  /// Returns a point of the field of view; `across` is -1..1, `down` is 0..1.
  PixelPoint at(double across, double down) const;
  double area() const;
};

/// Computes beyond() for many points of one model.
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
  PixelPoint at, outward;  ///< outward is a unit vector
  Edge edge = kLeft;
};

/// Points on the outline about `step_px` apart; a face that is a single point has none.
std::vector<EdgeSample> edgeSamples(const FovModel& model, double step_px);

/// Access to the parameters by index: x, y, turn, half, outer, and, for fans, inner. parameters() returns their number.
int parameters(const FovModel& model);
double& parameter(FovModel& model, int index);

}  // namespace insonate::fit
