#pragma once

#include <insonate/core/Vec3.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace insonate {

/// Velocity of the blood in one vessel at one moment, described along the vessel's center line in undeformed tissue.
/// The velocity in the lumen is point.scale * profile * point.direction.
struct BloodTube {
  static constexpr int kProfile = 33;
  struct Point {
    Vec3 position_mm;  ///< point of the center line, patient LPS
    Vec3 direction;    ///< direction in which blood flows forward along the vessel, unit
    double radius_mm = 0;
    /// Velocity relative to `profile_mmps`: the vessel may be narrower or wider here than where the profile applies. 0:
    /// the vessel is closed.
    double scale = 1;
  };
  std::uint8_t label = 0;     ///< label of the vessel in the label map
  std::vector<Point> course;  ///< center line from one end to the other; at least one point
  /// Forward velocity by relative distance from the center line: entry i is at i / (kProfile - 1) of the distance
  /// between center line and wall.
  std::array<double, kProfile> profile_mmps{};

  /// Returns the profile at a relative distance from the center line, interpolated linearly; 0 beyond the wall.
  double profileAt_mmps(double fromCenter) const;
};

/// Velocities of the blood in the vessels of a patient at one moment.
struct BloodFlow {
  std::vector<BloodTube> tubes;

  bool empty() const { return tubes.empty(); }
};

/// Place of a point in the vessel that contains it.
struct PlaceInTube {
  const BloodTube* tube = nullptr;
  int segment = 0;           ///< index of the first of the two points of the center line between which the place lies
  double along = 0;          ///< position between these two points, 0 to 1
  double fromCenter_mm = 0;  ///< distance from the center line
};

/// Finds the vessel with this label whose center line is nearest to a point, relative to the radius of the vessel.
/// Empty if there is none within 1.7 radii.
std::optional<PlaceInTube> placeInTubes(const BloodFlow& flow, std::uint8_t label, Vec3 patient_mm);

/// Returns the velocity of blood at a point in a lumen, mm/s, patient LPS. `depth_mm` is the distance from the point to
/// the wall of the lumen. The relative distance from the center line is r / (r + depth), with the distance r from the
/// center line, so that the velocity is 0 at the wall also where the lumen is not round. Returns zero outside vessels
/// and in vessels that the flow does not contain.
Vec3 bloodVelocity_mmps(const BloodFlow& flow, std::uint8_t label, Vec3 patient_mm, double depth_mm);

}  // namespace insonate
