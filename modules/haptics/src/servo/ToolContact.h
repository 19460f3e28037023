#pragma once

#include <insonate/haptics/Force.h>
#include <insonate/haptics/HapticServo.h>

#include <array>

namespace insonate::haptics {

/// A line segment with a radius, patient space.
struct Capsule {
  Vec3 from, to;
  double radius_mm = 0;
};

/// The two closest points of two line segments.
struct NearestPoints {
  Vec3 onA, onB;
};
NearestPoints nearestPoints(const Capsule& a, const Capsule& b);

/// Contact force between probe and needle: Table II of the thesis. The side on which they first touched is stored, so
/// that the tools do not pass through each other if a hand pushes harder than its device.
class ToolContact {
 public:
  void reset() { *this = {}; }
  /// Computes the forces on both tools, each about its own tool's origin. Returns whether they touch.
  bool push(const Transform& patientFromProbe, const Transform& patientFromNeedle, const ToolShapes& shapes,
            double stiffness_Npmm, Force& onProbe, Force& onNeedle) noexcept;

 private:
  struct Pair {
    bool touches = false;
    Vec3 towardsNeedle;
  };
  std::array<Pair, 2> pairs_;  // needle with face and needle with handle
};

}  // namespace insonate::haptics
