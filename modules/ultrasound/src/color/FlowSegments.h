#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/BloodFlow.h>

#include <span>
#include <vector>

namespace insonate {

/// Part of a vessel's center line between two points, in the probe frame.
struct FlowSegment {
  float x, y, z, dx, dy, dz;        ///< first point, and vector to the second
  float perLength2;                 ///< 1 / squared length; 0 for a single point
  float radius_mm, radiusChange;    ///< radius at the first point; change to the second
  float scale, scaleChange;         ///< BloodTube::Point::scale
  Vec3 direction, directionChange;  ///< BloodTube::Point::direction, probe frame
  std::uint8_t label;
  int tube, point;  ///< index of the tube, and of the first point in its course
};

/// Place of a point in the vessel that contains it; see PlaceInTube.
struct FlowPlace {
  int segment = -1;  ///< index of the segment; -1: no vessel contains the point
  float along = 0, off_mm = 0;
};

/// The center lines of a BloodFlow in the probe frame.
class FlowSegments {
 public:
  /// Distance from a center line, in radii of the vessel, up to which a point can lie in the vessel.
  static constexpr float kReach_radii = 1.7F;

  /// Takes the segments that lie within `reach_mm` of the plane of the image. Allocates nothing if it has had as many
  /// segments before.
  void update(const BloodFlow& flow, const Transform& patientFromProbe, double reach_mm);

  /// Writes to `near` the indices of the segments with this label that can contain a point of the box.
  void select(std::uint8_t label, Vec3 low_mm, Vec3 high_mm, std::vector<int>& near) const;

  /// Finds the vessel that contains a point, among selected segments (see placeInTubes()).
  FlowPlace find(std::span<const int> near, float x, float y, float z) const;
  const FlowSegment& segment(int index) const { return segments_[index]; }
  const std::vector<FlowSegment>& all() const { return segments_; }

  /// Returns the velocity of the blood along `beam` at a point (see bloodVelocity_mmps()), using selected segments.
  float along(std::span<const int> near, float x, float y, float z, float depth_mm, Vec3 beam) const;

 private:
  const BloodFlow* flow_ = nullptr;
  std::vector<FlowSegment> segments_;
};

}  // namespace insonate
