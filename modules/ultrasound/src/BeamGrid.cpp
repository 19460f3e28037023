#include <insonate/ultrasound/BeamGrid.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {

BeamGrid::BeamGrid(const Probe& probe, const ImagingSettings& settings)
    : shape_(probe.shape), scanlines_(settings.scanlines), samples_(settings.samples), depth_mm_(settings.depth_mm) {
  const bool linear = shape_ == ProbeShape::Linear;
  pitch_ = (linear ? probe.width_mm : probe.fovAngle_deg * std::numbers::pi / 180) / scanlines_;
  radius_mm_ = linear ? 0 : probe.faceRadius_mm;
  steering_rad_ = linear ? settings.steering_deg * std::numbers::pi / 180 : 0;
  depthAlong_mm_ = depth_mm_ / std::cos(steering_rad_);
  step_mm_ = depthAlong_mm_ / samples_;
}

Vec3 BeamGrid::origin(double scanline) const {
  const double across = (scanline - 0.5 * (scanlines_ - 1)) * pitch_;
  if (shape_ == ProbeShape::Linear) return {across, 0, 0};
  // The virtual apex lies at z = -r1, so that the middle of the face is the origin.
  return {radius_mm_ * std::sin(across), 0, radius_mm_ * (std::cos(across) - 1)};
}

Vec3 BeamGrid::direction(double scanline) const {
  if (shape_ == ProbeShape::Linear) return {std::sin(steering_rad_), 0, std::cos(steering_rad_)};
  const double angle = (scanline - 0.5 * (scanlines_ - 1)) * pitch_;
  return {std::sin(angle), 0, std::cos(angle)};
}

double BeamGrid::scanlineSpacing_mm(double range_mm) const {
  return shape_ == ProbeShape::Linear ? pitch_ * std::cos(steering_rad_) : pitch_ * (radius_mm_ + range_mm);
}

BeamGrid::Location BeamGrid::locate(double lateral_mm, double axial_mm) const {
  double across = lateral_mm - axial_mm * std::tan(steering_rad_), range_mm = axial_mm / std::cos(steering_rad_);
  if (shape_ != ProbeShape::Linear) {
    const double fromApex_mm = axial_mm + radius_mm_;
    across = std::atan2(lateral_mm, fromApex_mm);
    range_mm = std::hypot(lateral_mm, fromApex_mm) - radius_mm_;
  }
  const double scanline = across / pitch_ + 0.5 * (scanlines_ - 1);
  const bool inside = std::abs(across) <= 0.5 * scanlines_ * pitch_ && range_mm >= 0 && range_mm <= depthAlong_mm_;
  return {scanline, sampleAt(range_mm), inside};
}

double BeamGrid::maxLateral_mm() const {
  const double half = 0.5 * scanlines_ * pitch_;
  return shape_ == ProbeShape::Linear ? half + std::max(0.0, depth_mm_ * std::tan(steering_rad_))
                                      : (radius_mm_ + depth_mm_) * std::sin(half);
}

double BeamGrid::minLateral_mm() const {
  const double half = 0.5 * scanlines_ * pitch_;
  return shape_ == ProbeShape::Linear ? -half + std::min(0.0, depth_mm_ * std::tan(steering_rad_)) : -maxLateral_mm();
}

double BeamGrid::minAxial_mm() const {
  return shape_ == ProbeShape::Linear ? 0 : radius_mm_ * (std::cos(0.5 * scanlines_ * pitch_) - 1);
}

double BeamGrid::maxAxial_mm() const {
  return depth_mm_;
}

std::vector<double> steeringAngles_deg(const Probe& probe, const ImagingSettings& settings) {
  const double middle_deg = settings.steering_deg;
  if (probe.shape != ProbeShape::Linear || settings.compoundingAngles < 3) return {middle_deg};
  if (settings.compoundingAngles == 3) return {middle_deg, middle_deg - 8, middle_deg + 8};
  return {middle_deg, middle_deg - 5, middle_deg + 5, middle_deg - 10, middle_deg + 10};
}

}  // namespace insonate
