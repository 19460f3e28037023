#pragma once

#include <insonate/core/Transform.h>
#include <insonate/deformation/TissuePlane.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace insonate::test {

/// Tissue of exactly known shape: layers below the skin, in them circles and blocks; air above. Frame of the tissue,
/// mm: x as in the probe frame, z = 0 at the skin (where that is round, at its top), growing into the body. Shapes that
/// come later lie over earlier ones; shapes of one label should not touch, as distances are to the nearest of them.
class AnalyticPlane : public TissuePlane {
 public:
  struct Layer {
    double thickness_mm = 0;
    std::uint8_t label = kSoftTissue;
  };
  struct Circle {
    double x_mm = 0, z_mm = 0, radius_mm = 1;
    std::uint8_t label = kVein;
  };
  struct Block {
    double left_mm = 0, top_mm = 0, right_mm = 1, bottom_mm = 1;
    std::uint8_t label = kBone;
  };

  /// Position of the probe: its face lies `press_mm` below the skin's top and `slide_mm` to the side.
  double press_mm = 0, slide_mm = 0;

  double skinRadius_mm = 0;                                      ///< of a round neck about (0, radius); 0 is flat
  double leftEnd_mm = -std::numeric_limits<double>::infinity();  ///< of the body: air beyond
  double rightEnd_mm = std::numeric_limits<double>::infinity();
  std::vector<Layer> layers;         ///< from the skin inwards
  std::uint8_t below = kSoftTissue;  ///< the last layer
  std::vector<Circle> circles;
  std::vector<Block> blocks;

  /// Pose in the tissue's frame taken as the patient's, with y across the plane.
  Transform patientFromProbe() const { return {Mat3{}, {slide_mm, 0, press_mm}}; }

  void sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const override {
    for (std::size_t i = 0; i < at.size(); ++i) tissue[i] = of(at[i].x_mm + slide_mm, at[i].z_mm + press_mm);
  }

  /// At a point of the tissue's frame.
  PlaneTissue of(double x_mm, double z_mm) const {
    PlaneTissue here;
    const double skin_mm = skinAt(x_mm, z_mm);
    here.skin_mm = cut(skin_mm);
    if (skin_mm < 0) here.label = below;
    double top_mm = 0;
    for (const Layer& layer : layers) {
      const double bottom_mm = top_mm + layer.thickness_mm;
      add(layer.label, std::max(top_mm + skin_mm, -skin_mm - bottom_mm), skin_mm, here);
      top_mm = bottom_mm;
    }
    for (const Circle& c : circles) add(c.label, std::hypot(x_mm - c.x_mm, z_mm - c.z_mm) - c.radius_mm, skin_mm, here);
    for (const Block& b : blocks) add(b.label, toBlock(b, x_mm, z_mm), skin_mm, here);
    return here;
  }

 private:
  static float cut(double distance_mm) {
    return static_cast<float>(std::clamp<double>(distance_mm, -PlaneTissue::kFar_mm, PlaneTissue::kFar_mm));
  }

  double skinAt(double x_mm, double z_mm) const {
    const double skin_mm = skinRadius_mm > 0 ? std::hypot(x_mm, z_mm - skinRadius_mm) - skinRadius_mm : -z_mm;
    return std::max({skin_mm, leftEnd_mm - x_mm, x_mm - rightEnd_mm});
  }

  static double toBlock(const Block& b, double x_mm, double z_mm) {
    const double dx = std::max(b.left_mm - x_mm, x_mm - b.right_mm);
    const double dz = std::max(b.top_mm - z_mm, z_mm - b.bottom_mm);
    return std::min(std::max(dx, dz), 0.0) + std::hypot(std::max(dx, 0.0), std::max(dz, 0.0));
  }

  /// A shape of which the point is `distance_mm` away, negative inside.
  static void add(std::uint8_t label, double distance_mm, double skin_mm, PlaneTissue& here) {
    if (distance_mm <= 0 && skin_mm < 0) here.label = label;
    float* nearest = label == kArtery ? &here.artery_mm
                     : label == kVein ? &here.vein_mm
                     : label == kBone ? &here.bone_mm
                                      : nullptr;
    if (nearest) *nearest = std::min(*nearest, cut(distance_mm));
  }
};

}  // namespace insonate::test
