#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <vector>

namespace insonate::views {

/// A point of the imaging plane in the probe frame.
struct PlanePoint {
  double lateral_mm = 0, axial_mm = 0;
};

/// The field of view as strips from face to depth: points come in pairs (face, depth) from the first edge to the last.
std::vector<PlanePoint> fieldOfViewStrip(const Probe& probe, const ImagingSettings& settings);

/// Its outline, once round.
std::vector<PlanePoint> fieldOfViewOutline(const Probe& probe, const ImagingSettings& settings);

}  // namespace insonate::views
