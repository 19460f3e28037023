#include <insonate/ultrasound/FovFit.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kPhasedFace_mm = 5;  // a fan with a smaller face belongs to a phased array

}  // namespace

double depthOf_px(const FovShape& shape) {
  return shape.shape == ProbeShape::Linear ? shape.depth_px : shape.r2_px - shape.r1_px;
}

PixelPoint pointAtFraction(const FovShape& shape, double acrossFraction, double depthFraction) {
  const double turn = shape.rotation_deg * kRadians, c = std::cos(turn), s = std::sin(turn);
  double u = acrossFraction * shape.width_px / 2, v = depthFraction * shape.depth_px;
  if (shape.shape != ProbeShape::Linear) {
    const double angle = acrossFraction * shape.alpha_deg / 2 * kRadians;
    const double reach = shape.r1_px + depthFraction * (shape.r2_px - shape.r1_px);
    u = reach * std::sin(angle), v = reach * std::cos(angle);
  }
  const double right = c * u + s * v, below = -s * u + c * v;
  return {shape.origin.x + right, shape.origin.y + (shape.upsideDown ? -below : below)};
}

std::vector<PixelPoint> outlineOf(const FovShape& shape) {
  const int parts = shape.shape == ProbeShape::Linear ? 1 : 64;
  std::vector<PixelPoint> outline;
  for (int k = 0; k <= parts; ++k) outline.push_back(pointAtFraction(shape, 2.0 * k / parts - 1, 0));
  for (int k = parts; k >= 0; --k) outline.push_back(pointAtFraction(shape, 2.0 * k / parts - 1, 1));
  return outline;
}

Result<Probe> probeFromFit(const FovShape& shape, double mm_per_px, const Probe& base, std::string name) {
  if (!(mm_per_px > 0) || !std::isfinite(mm_per_px)) return fail("The depth scale must be above 0 mm per pixel.");
  Probe probe = base;
  probe.name = std::move(name);
  probe.shape = shape.shape;
  if (shape.shape == ProbeShape::Linear) {
    probe.width_mm = shape.width_px * mm_per_px;
  } else {
    probe.fovAngle_deg = shape.alpha_deg;
    probe.faceRadius_mm = shape.r1_px * mm_per_px;
    probe.shape = probe.faceRadius_mm < kPhasedFace_mm ? ProbeShape::Phased : ProbeShape::Curvilinear;
  }
  probe.defaultDepth_mm = depthOf_px(shape) * mm_per_px;
  probe.minDepth_mm = std::min(probe.minDepth_mm, probe.defaultDepth_mm);
  probe.maxDepth_mm = std::max(probe.maxDepth_mm, probe.defaultDepth_mm);
  probe.defaultFocus_mm = std::min(probe.defaultFocus_mm, probe.defaultDepth_mm);
  if (auto ok = validate(probe); !ok) return tl::unexpected(ok.error());
  return probe;
}

}  // namespace insonate
