#pragma once

#include "BodySurface.h"
#include "Curve.h"

#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace insonate::phantom {

/// Axis-aligned rectangle of one level, model mm.
struct Box2 {
  double minX = 0, maxX = 0, minY = 0, maxY = 0;
};

/// A shape at one level: where it can be, and its signed distance (mm, negative inside, first order).
struct Section {
  Box2 bounds_mm;
  std::function<double(const Site&)> distance_mm;
};

/// A shape as a function of level; empty where the level does not meet it.
using Shape = std::function<std::optional<Section>(const BodySurface::Slice&, double z_mm)>;

/// Side of the body on which a shape stands. Shapes are written with x as the distance from the midline toward their
/// own side, so that left and right share one description.
enum class Side { kRight, kLeft };

/// Patient x of a lateral coordinate.
constexpr double patientX(Side side, double lateral_mm) {
  return side == Side::kRight ? -lateral_mm : lateral_mm;
}

/// A cross-section's form.
enum class Form {
  kOval,    ///< ends of the column are half ellipsoids
  kBelly,   ///< of muscle: lobed, thins out into a tendon at both ends of the column
  kLens,    ///< of flat muscle: sharp edges as well
  kFaceted  ///< of a soft vein: flat toward its neighbors, dented by the one that its `facing_deg` points to
};

/// An upright organ or muscle: an oval with smoothly changing center, half axes and turn.
struct Column {
  /// lateral and posterior position of the center, half axes along lateral and posterior (mm), turn (degrees, from
  /// lateral toward posterior).
  Curve<5> course;
  double taper_mm = 3;        ///< length over which each end rounds off
  double irregular_mm = 0.5;  ///< amplitude of the boundary's noise
  Form form = Form::kOval;
  double facing_deg = 0;  ///< of a faceted form, from lateral toward posterior
};
Shape column(Side side, Column column, std::uint32_t seed);

/// A flat muscle that hugs the investing fascia: a lens in arc length along the fascia and depth below it, whose
/// edges lie nearer to the fascia than its middle.
struct Sheet {
  /// angle from the front (degrees), depth of the center below the fascia, half width along it, half thickness (mm).
  Curve<4> course;
  double taper_mm = 4;
  double irregular_mm = 0.5;
  Form form = Form::kLens;  ///< or kOval
};
Shape sheet(Side side, Sheet sheet, std::uint32_t seed);

/// A round cord in any direction, through points of (lateral, posterior, head) with radius.
struct Tube {
  struct Knot {
    Vec3 p_mm;
    double radius_mm;
  };
  std::vector<Knot> knots;
  double flatness = 1;  ///< above 1: thinner from head to foot by this factor
  double irregular_mm = 0.15;
  double oval = 0;  ///< relative departure of the cross-section from a circle
};
Shape tube(Side side, Tube tube, std::uint32_t seed);

/// Position and radius of a tube's center line, finely sampled (used where another thing follows it).
std::vector<Tube::Knot> centreLine(const std::vector<Tube::Knot>& knots);

/// Union.
Shape join(std::vector<Shape> shapes);
/// The space between two distances from a shape's boundary (positive outside, up to 3 mm).
Shape shell(Shape inner, double from_mm, double to_mm);
/// The part of a shape where a function of the model position is negative.
Shape clip(Shape shape, std::function<double(Vec3)> limit_mm);

}  // namespace insonate::phantom
