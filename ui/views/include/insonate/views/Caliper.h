#pragma once

#include <array>
#include <string>
#include <vector>

namespace insonate::views {

/// A point of the ultrasound image in the probe frame, in mm: lateral toward the marker, axial into the body.
struct ImagePoint {
  double lateral_mm = 0, axial_mm = 0;
  bool operator==(const ImagePoint&) const = default;
};

enum class CaliperKind {
  Distance,  ///< distance from point 0 to point 1
  /// points 0 and 1 are the ends of the first axis; the distance of point 2 from the first axis is half the second axis
  Ellipse,
  Angle,  ///< the angle at point 1 between the lines to points 0 and 2
};

struct Caliper {
  CaliperKind kind = CaliperKind::Distance;
  std::array<ImagePoint, 3> points;  ///< a distance uses only points 0 and 1
};

/// Values that a caliper measures; fields that do not apply to its kind are 0.
struct CaliperValues {
  double length_mm = 0;         ///< length of a distance; first axis of an ellipse
  double width_mm = 0;          ///< second axis of an ellipse
  double circumference_mm = 0;  ///< circumference of an ellipse, by Ramanujan's second approximation
  double area_mm2 = 0;          ///< area of an ellipse
  double angle_deg = 0;         ///< angle, 0 to 180; 0 if one of the lines has no length
};

CaliperValues measure(const Caliper& caliper);
/// Returns the outline of an ellipse as points of a closed polygon; empty for other kinds.
std::vector<ImagePoint> outline(const Caliper& caliper);
/// Formats the values: "12.3 mm", "9.8 x 7.2 mm, 55 mm²", "41°".
std::string caliperText(const Caliper& caliper);

}  // namespace insonate::views
