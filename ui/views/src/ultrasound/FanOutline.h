#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <vector>

namespace insonate::views {

/// A point of the imaging plane in the probe's frame.
struct PlanePoint {
  double lateral_mm = 0, axial_mm = 0;
};

/// Returns the field of view as a triangle strip: pairs of points (face, maximum depth) from the first edge to the
/// last.
std::vector<PlanePoint> fieldOfViewStrip(const Probe& probe, const ImagingSettings& settings);

/// Returns the outline of the field of view as a closed polygon.
std::vector<PlanePoint> fieldOfViewOutline(const Probe& probe, const ImagingSettings& settings);

}  // namespace insonate::views
