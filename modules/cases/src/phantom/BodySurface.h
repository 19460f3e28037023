#pragma once

#include "Curve.h"

#include <insonate/core/Vec3.h>

#include <array>
#include <cstdint>
#include <vector>

namespace insonate::phantom {

/// A point of a model in the coordinates by which shapes are defined. Model frame: patient LPS mm, with the origin of
/// the region: in the neck at the midline and the lower cricoid.
struct Site {
  Vec3 p_mm;         ///< model position after the warp that makes boundaries irregular
  double angle = 0;  ///< angle about the region's axis, 0 at the front, positive to the patient's right, radians
  double belowFascia_mm = 0;  ///< depth below the investing fascia (negative in the layers above it)
  double belowSkin_mm = 0;    ///< depth below the skin's surface (negative outside the body)
  double skin_mm = 0;         ///< thickness of the skin above the point
};

/// Shape of a region of the body: its investing fascia, and the distribution of fat above the fascia.
struct Outline {
  /// Radius of the fascia (mm) every 22.5 degrees from front to back, by level; the sides are mirror images.
  Curve<9> fascia_mm;
  double (*fatFactor)(double angle, double z_mm);  ///< factor on the mean thickness of the fat, by angle and level
};

struct LayerOptions {
  const Outline* outline = nullptr;  ///< never null in use; outlives the surface
  double fat_mm = 4.5;               ///< mean thickness of the subcutaneous fat
  double skin_mm = 1.6;              ///< mean thickness of the skin
  double girth_mm = 0;               ///< increase of the region's girth, added to the usual radius of the fascia
  std::uint32_t seed = 1;
};

/// The platysma: a sheet of muscle in the subcutaneous fat.
struct Platysma {
  double height = 0.3;  ///< height of the muscle above the fascia, as a share of the fat's thickness
  double halfThickness_mm = 0.55;
  double first = 0.14, last = 1.7;  ///< angles of the muscle's edges from the front, radians
  double top_z_mm = 46;
};

/// A region's outline: radius of the investing fascia by angle and level, covered by fat and skin. The object is
/// immutable.
class BodySurface {
 public:
  explicit BodySurface(const LayerOptions& options) : options_(options) {}

  /// The surface in one direction: radius of the fascia, cosine of the surface's slant, total thickness of the layers
  /// above the fascia (skin included), and thickness of the skin.
  struct Ray {
    double radius_mm, slant, layers_mm, skin_mm;
  };

  /// The outline at one level, tabulated by angle, so that many sites of one slice are computed quickly.
  class Slice {
   public:
    Site site(Vec3 p_mm) const;
    double fasciaRadius_mm(double angle) const { return at(angle).radius_mm; }

   private:
    friend class BodySurface;
    Ray at(double angle) const;
    std::vector<Ray> rays_;
  };
  Slice slice(double z_mm) const;

  /// Returns the depth of one point below the skin's surface (negative outside), mm.
  double belowSkin_mm(Vec3 p_mm) const;

  static constexpr double kAxisY_mm = 40;  ///< y of the region's axis, whose x is 0

 private:
  struct Level {
    double z_mm;
    std::array<double, 9> here, above, below;
  };
  Level level(double z_mm) const;
  Ray ray(const Level& level, double angle) const;
  double fat_mm(double angle, double z_mm) const;
  double skin_mm(double angle, double z_mm) const;

  LayerOptions options_;
};

}  // namespace insonate::phantom
