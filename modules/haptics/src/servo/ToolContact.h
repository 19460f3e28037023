#pragma once

#include <insonate/haptics/Force.h>
#include <insonate/haptics/HapticServo.h>

#include <array>

namespace insonate::haptics {

/// A line with a radius, patient space.
struct Capsule {
  Vec3 from, to;
  double radius_mm = 0;
};

/// The points of two lines that are nearest to each other.
struct NearestPoints {
  Vec3 onA, onB;
};
NearestPoints nearestPoints(const Capsule& a, const Capsule& b);

/// Probe and needle push each other away: Table II of the thesis. The side on which they met is kept, so that a hand
/// that pushes harder than its device does not snap through.
class ToolContact {
 public:
  void reset() { *this = {}; }
  /// Forces on both, each about its own tool's origin. Returns whether they touch.
  bool push(const Transform& patientFromProbe, const Transform& patientFromNeedle, const ToolShapes& shapes,
            double stiffness_Npmm, Force& onProbe, Force& onNeedle) noexcept;

 private:
  struct Pair {
    bool touches = false;
    Vec3 towardsNeedle;
  };
  std::array<Pair, 2> pairs_;  // needle with face and with handle
};

}  // namespace insonate::haptics
