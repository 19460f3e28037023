#pragma once

#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string_view>
#include <vector>

namespace insonate {

/// Spacing of the gates along a scanline, in mm: the largest multiple of the sample spacing of which 2.4 fit into the
/// length of the pulse.
double gateDistance_mm(const Probe& probe, const ImagingSettings& settings);

/// The detail_mm of a scene that this probe can make use of: 1.2 where its beam is no narrower than that, else 0.7.
double sceneDetail_mm(const Probe& probe, const ImagingSettings& settings);

/// Work of one stage of a frame by formula, from the sizes of its grids: an estimate to compare measured times with,
/// not a count of instructions.
struct StageWork {
  std::string_view name;  ///< as in Engine::stages(), and compound, compress, smooth, scan_convert of the display
  double operations = 0;  ///< single-precision and 32-bit integer; a multiply-add is two
  double bytes = 0;       ///< read and written once each, were caches without limit
};

/// Work of the `cpu` engine and the display; stages whose cost depends on the scene's shape (contact) are left out.
/// The settings must be valid for the probe.
std::vector<StageWork> frameWork(const Probe& probe, const ImagingSettings& settings, const AcousticScene& scene);

}  // namespace insonate
