#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <vector>

namespace insonate {

/// Positions of the samples of a frame, in the probe frame. Sample k of scanline l is at origin(l) + direction(l) *
/// range_mm(k), in mm; k and l may be fractional.
class BeamGrid {
 public:
  BeamGrid(const Probe& probe, const ImagingSettings& settings);

  int scanlines() const { return scanlines_; }
  int samples() const { return samples_; }
  double step_mm() const { return step_mm_; }
  double range_mm(double sample) const { return (sample + 0.5) * step_mm_; }
  double sampleAt(double range_mm) const { return range_mm / step_mm_ - 0.5; }

  Vec3 origin(double scanline) const;
  Vec3 direction(double scanline) const;
  /// Returns the distance between neighboring scanlines at a range from the face, perpendicular to the scanlines, mm.
  double scanlineSpacing_mm(double range_mm) const;
  /// Returns the distance between scanlines along the face of a linear probe, mm.
  double pitch_mm() const { return pitch_; }

  /// Position of a point of the image plane (y = 0), as fractional scanline and sample. `inside`, true: the point is in
  /// the field of view, which is a rectangle, or a fan between r1 (radius of the face) and r2. The edges of the field
  /// of view lie half a scanline outside the first and last scanlines.
  struct Location {
    double scanline, sample;
    bool inside;
  };
  Location locate(double lateral_mm, double axial_mm) const;

  /// Return the bounding box of the field of view in the image plane, probe frame.
  double minLateral_mm() const, maxLateral_mm() const, minAxial_mm() const, maxAxial_mm() const;

 private:
  ProbeShape shape_;
  int scanlines_, samples_;
  double step_mm_, depth_mm_;
  double pitch_;              // distance between scanlines at the face: linear: mm, else radians
  double radius_mm_;          // r1, distance from the virtual apex to the face; 0 for linear
  double steering_rad_;       // steering angle; 0 for fans
  double depthAlong_mm_ = 0;  // range from the face at which a scanline reaches the image's depth
};

/// Returns the steering angles of spatial compounding. The first angle is the steering angle of the settings. With
/// three angles, the others are 8 degrees to either side of the first; with five angles, 5 and 10 degrees to either
/// side. All angles are limited to the range that validate() accepts. A fan has one angle.
std::vector<double> steeringAngles_deg(const Probe& probe, const ImagingSettings& settings);

}  // namespace insonate
