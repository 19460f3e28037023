#include <insonate/ultrasound/BeamGrid.h>

#include <cmath>
#include <numbers>

namespace insonate {

BeamGrid::BeamGrid(const Probe& probe, const ImagingSettings& settings)
    : shape_(probe.shape),
      scanlines_(settings.scanlines),
      samples_(settings.samples),
      step_mm_(settings.depth_mm / settings.samples),
      depth_mm_(settings.depth_mm) {
  const bool linear = shape_ == ProbeShape::Linear;
  pitch_ = (linear ? probe.width_mm : probe.fovAngle_deg * std::numbers::pi / 180) / scanlines_;
  radius_mm_ = linear ? 0 : probe.faceRadius_mm;
}

Vec3 BeamGrid::origin(double scanline) const {
  const double across = (scanline - 0.5 * (scanlines_ - 1)) * pitch_;
  if (shape_ == ProbeShape::Linear) return {across, 0, 0};
  // The virtual apex lies at z = -r1, so that the middle of the face is the origin.
  return {radius_mm_ * std::sin(across), 0, radius_mm_ * (std::cos(across) - 1)};
}

Vec3 BeamGrid::direction(double scanline) const {
  if (shape_ == ProbeShape::Linear) return {0, 0, 1};
  const double angle = (scanline - 0.5 * (scanlines_ - 1)) * pitch_;
  return {std::sin(angle), 0, std::cos(angle)};
}

double BeamGrid::scanlineSpacing_mm(double range_mm) const {
  return shape_ == ProbeShape::Linear ? pitch_ : pitch_ * (radius_mm_ + range_mm);
}

BeamGrid::Location BeamGrid::locate(double lateral_mm, double axial_mm) const {
  double across = lateral_mm, range_mm = axial_mm;
  if (shape_ != ProbeShape::Linear) {
    const double fromApex_mm = axial_mm + radius_mm_;
    across = std::atan2(lateral_mm, fromApex_mm);
    range_mm = std::hypot(lateral_mm, fromApex_mm) - radius_mm_;
  }
  const double scanline = across / pitch_ + 0.5 * (scanlines_ - 1);
  const bool inside = std::abs(across) <= 0.5 * scanlines_ * pitch_ && range_mm >= 0 && range_mm <= depth_mm_;
  return {scanline, sampleAt(range_mm), inside};
}

double BeamGrid::maxLateral_mm() const {
  const double half = 0.5 * scanlines_ * pitch_;
  return shape_ == ProbeShape::Linear ? half : (radius_mm_ + depth_mm_) * std::sin(half);
}

double BeamGrid::minLateral_mm() const {
  return -maxLateral_mm();
}

double BeamGrid::minAxial_mm() const {
  return shape_ == ProbeShape::Linear ? 0 : radius_mm_ * (std::cos(0.5 * scanlines_ * pitch_) - 1);
}

double BeamGrid::maxAxial_mm() const {
  return depth_mm_;
}

}  // namespace insonate
