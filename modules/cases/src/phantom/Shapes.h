#pragma once

#include "BodySurface.h"
#include "Curve.h"

#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace insonate::phantom {

/// Axis-aligned rectangle at one level, model mm.
struct Box2 {
  double minX = 0, maxX = 0, minY = 0, maxY = 0;
};

/// A shape at one level: its bounding box, and its signed distance (mm, negative inside, first order).
struct Section {
  Box2 bounds_mm;
  std::function<double(const Site&)> distance_mm;
};

/// A shape as a function of level; returns no value if the shape does not extend to the level.
using Shape = std::function<std::optional<Section>(const BodySurface::Slice&, double z_mm)>;

/// Side of the body. Shapes are defined with x as the distance from the midline toward their own side, so that left and
/// right share one definition.
enum class Side { kRight, kLeft };

/// Returns patient x for a distance from the midline.
constexpr double patientX(Side side, double lateral_mm) {
  return side == Side::kRight ? -lateral_mm : lateral_mm;
}

/// Form of a cross-section.
enum class Form {
  kOval,    ///< oval; the ends of the column are half ellipsoids
  kBelly,   ///< muscle: lobed, thins out into a tendon at both ends of the column
  kLens,    ///< flat muscle: like kBelly, with sharp edges
  kFaceted  ///< soft vein: flat toward its neighbors, indented by the neighbor in direction `facing_deg`
};

/// An upright organ or muscle: an oval whose center, half axes and rotation change smoothly with the level.
struct Column {
  /// Lateral and posterior position of the center, half axes along lateral and posterior (mm), rotation (degrees, from
  /// lateral toward posterior).
  Curve<5> course;
  double taper_mm = 3;        ///< length over which each end of the column is rounded
  double irregular_mm = 0.5;  ///< amplitude of random irregularities of the boundary
  Form form = Form::kOval;
  double facing_deg = 0;  ///< kFaceted: direction of the indenting neighbor, from lateral toward posterior
};
Shape column(Side side, Column column, std::uint32_t seed);

/// A flat muscle that follows the investing fascia. Its cross-section is a lens, whose coordinates are the arc length
/// along the fascia and the depth below the fascia. The edges of the sheet lie closer to the fascia than its middle.
struct Sheet {
  /// Angle from the front (degrees), depth of the center below the fascia, half width along the fascia, half thickness
  /// (mm).
  Curve<4> course;
  double taper_mm = 4;
  double irregular_mm = 0.5;
  Form form = Form::kLens;  ///< form of the cross-section: kLens or kOval
};
Shape sheet(Side side, Sheet sheet, std::uint32_t seed);

/// A round cord in any direction, through points (lateral, posterior, head) with a radius each.
struct Tube {
  struct Knot {
    Vec3 p_mm;
    double radius_mm;
  };
  std::vector<Knot> knots;
  double flatness = 1;  ///< above 1: height from head to foot divided by this factor
  double irregular_mm = 0.15;
  double oval = 0;  ///< oval cross-section: relative deviation from a circle
};
Shape tube(Side side, Tube tube, std::uint32_t seed);

/// Returns closely spaced points of a tube's center line with their radii, for structures that follow the tube.
std::vector<Tube::Knot> centerLine(const std::vector<Tube::Knot>& knots);

/// Returns the union of shapes.
Shape join(std::vector<Shape> shapes);
/// Returns the space between two signed distances from a shape's boundary, positive outside; both at most 3 mm.
Shape shell(Shape inner, double from_mm, double to_mm);
/// Returns the part of a shape in which a function of the model position is negative.
Shape clip(Shape shape, std::function<double(Vec3)> limit_mm);

}  // namespace insonate::phantom
