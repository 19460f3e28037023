#pragma once

#include <insonate/core/Vec3.h>

#include <array>
#include <cstdint>
#include <vector>

namespace insonate::phantom {

/// A point of the neck model in the coordinates by which shapes are defined. Model frame: patient LPS mm, midline x =
/// 0, lower cricoid z = 0.
struct Site {
  Vec3 p_mm;                  ///< model position after the warp that makes boundaries irregular
  double angle = 0;           ///< angle about the neck's axis, 0 at the front, positive to the patient's right, radians
  double belowFascia_mm = 0;  ///< depth below the investing fascia (negative in the layers above it)
  double belowSkin_mm = 0;    ///< depth below the skin's surface (negative outside the body)
  double skin_mm = 0;         ///< thickness of the skin above the point
};

struct LayerOptions {
  double fat_mm = 4.5;   ///< mean thickness of the subcutaneous fat over the front and sides
  double skin_mm = 1.6;  ///< mean thickness of the skin
  double girth_mm = 0;   ///< increase of the neck's girth, added to the usual radius of the fascia
  std::uint32_t seed = 1;
};

/// The platysma: a sheet of muscle in the subcutaneous fat.
struct Platysma {
  double height = 0.3;  ///< height of the muscle above the fascia, as a share of the fat's thickness
  double halfThickness_mm = 0.55;
  double first = 0.14, last = 1.7;  ///< angles of the muscle's edges from the front, radians
  double top_z_mm = 46;
};

/// The neck's outline: radius of the investing fascia by angle and level, covered by fat and skin. The object is
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

  static constexpr double kAxisY_mm = 40;  ///< y of the neck's axis, whose x is 0

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
