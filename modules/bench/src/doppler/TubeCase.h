#pragma once

#include "report/CellTable.h"

#include <insonate/simulator/Imager.h>

#include <memory>
#include <string>
#include <utility>

namespace insonate::bench {

/// A straight tube of blood in even tissue, which crosses the beam of the linear probe at a known angle at a depth of
/// 20 mm. The probe frame is the patient frame.
struct TubeCase {
  static Result<TubeCase> make(double angle_deg, double radius_mm);

  /// Returns the velocity toward the probe in the middle of the color box, without noise, for plug flow.
  double middleVelocity_mmps(const std::string& engine, double speed_mmps) const;
  /// Returns the area of the colored pixels, and that of the lumen within the box.
  std::pair<double, double> areas_mm2(const std::string& engine, double speed_mmps) const;

  Probe probe;
  ImagingSettings settings;
  ColorSettings color;
  double angle_deg = 0, radius_mm = 0;
  std::shared_ptr<const AcousticScene> scene;

 private:
  Vec3 direction() const;
  double offAxis_mm(Vec3 probe_mm) const;
  BloodFlow flowOf(double speed_mmps) const;
  ColorFrame frameOf(const std::string& engine, double speed_mmps) const;
};

/// Integrates the velocities over the circle around a point of a vessel's center line.
double flowThrough_mm3ps(const BloodTube& tube, const BloodTube::Point& point);

}  // namespace insonate::bench
