#pragma once

#include <insonate/core/Vec3.h>

#include <array>
#include <cstdint>
#include <vector>

namespace insonate::phantom {

/// Where a point is, as the shapes see it. Model frame: patient LPS mm, midline x = 0, lower cricoid z = 0.
struct Site {
  Vec3 p_mm;                  ///< model position, after the warp that keeps boundaries irregular
  double angle = 0;           ///< about the neck's axis, 0 at the front, positive to the patient's right, radians
  double belowFascia_mm = 0;  ///< distance inside the investing fascia (negative: in the layers above it)
  double belowSkin_mm = 0;    ///< distance inside the skin surface (negative: outside the body)
};

struct LayerOptions {
  double fat_mm = 4.5;  ///< mean thickness of the subcutaneous fat over the front and sides
  std::uint32_t seed = 1;
};

/// The neck's outline: radius of the investing fascia by angle and level, with fat and skin laid on it. Immutable.
class BodySurface {
 public:
  explicit BodySurface(const LayerOptions& options) : options_(options) {}

  /// The surface in one direction: radius of the fascia, cosine of the surface's slant, layers above the fascia.
  struct Ray {
    double radius_mm, slant, layers_mm;
  };

  /// The outline of one level as a table over the angle: makes many sites of one slice cheap.
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

  /// Distance of one point inside the skin surface (negative outside), mm.
  double belowSkin_mm(Vec3 p_mm) const;

  /// Fat and skin above the fascia, mm; varies smoothly over the surface.
  double layers_mm(double angle, double z_mm) const;

  static constexpr double kAxisY_mm = 40;  ///< the neck's axis stands on (0, kAxisY_mm)
  static constexpr double kSkin_mm = 1.8;

 private:
  struct Level {
    double z_mm;
    std::array<double, 9> here, above, below;
  };
  Level level(double z_mm) const;
  Ray ray(const Level& level, double angle) const;

  LayerOptions options_;
};

}  // namespace insonate::phantom
