#pragma once

#include <insonate/haptics/Force.h>
#include <insonate/haptics/HapticServo.h>

#include <array>

namespace insonate::haptics {

/// Capsule: all points within a radius of a line segment; patient space.
struct Capsule {
  Vec3 from, to;
  double radius_mm = 0;
};

/// The two closest points of the line segments of two capsules.
struct NearestPoints {
  Vec3 onA, onB;
};
NearestPoints nearestPoints(const Capsule& a, const Capsule& b);

/// Contact force between probe and needle (Table II of the thesis, see modules/haptics/README.md). The side on which
/// they first touched is stored, so that the tools do not pass through each other if a hand pushes harder than its
/// device can.
class ToolContact {
 public:
  void reset() { *this = {}; }
  /// Computes the contact forces on both tools, with torques about each tool's own origin. Returns whether they touch.
  bool push(const Transform& patientFromProbe, const Transform& patientFromNeedle, const ToolShapes& shapes,
            double stiffness_Npmm, Force& onProbe, Force& onNeedle) noexcept;

 private:
  struct Pair {
    bool touches = false;
    Vec3 towardsNeedle;
  };
  std::array<Pair, 2> pairs_;  // contacts of the needle with the probe's face and with its handle
};

}  // namespace insonate::haptics
