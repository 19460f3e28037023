#pragma once

#include <array>
#include <string>
#include <vector>

namespace insonate::views {

/// A point of the ultrasound image: lateral (toward the marker) and axial (into the body) mm in the probe frame.
struct PicturePoint {
  double lateral_mm = 0, axial_mm = 0;
};

enum class CalliperKind {
  Distance,  ///< from point 0 to point 1
  Ellipse,   ///< points 0 and 1 end its one axis; point 2 is as far from that axis as the other one is long to a side
  Angle,     ///< at point 1, between the arms to points 0 and 2
};

struct Calliper {
  CalliperKind kind = CalliperKind::Distance;
  std::array<PicturePoint, 3> points;  ///< a distance uses two
};

/// Values that a caliper measures; fields that its kind lacks are 0.
struct CalliperValues {
  double length_mm = 0;         ///< distance; ellipse: its first axis
  double width_mm = 0;          ///< ellipse: its second axis
  double circumference_mm = 0;  ///< ellipse, by Ramanujan's second approximation
  double area_mm2 = 0;          ///< ellipse
  double angle_deg = 0;         ///< angle, 0..180; 0 where an arm has no length
};

CalliperValues measure(const Calliper& calliper);
/// The line of an ellipse, as corners of a closed ring; empty for other kinds.
std::vector<PicturePoint> outline(const Calliper& calliper);
/// "12.3 mm", "9.8 x 7.2 mm, 55 mm²", "41°"
std::string words(const Calliper& calliper);

}  // namespace insonate::views
