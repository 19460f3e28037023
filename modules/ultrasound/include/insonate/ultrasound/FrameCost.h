#pragma once

#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string_view>
#include <vector>

namespace insonate {

/// Returns the distance between gates, the points of a scanline at which echoes are computed, in mm: the largest
/// multiple of the sample spacing at which at least 2.4 gates fit into the pulse's length.
double gateDistance_mm(const Probe& probe, const ImagingSettings& settings);

/// Returns the value of `detail_mm` that suffices in AcousticScene::make() for this probe: 1.2 if its beam is at least
/// that wide, else 0.7.
double sceneDetail_mm(const Probe& probe, const ImagingSettings& settings);

/// Number of operations and bytes of one stage of a frame, computed by formula from the sizes of its grids: an estimate
/// for comparison with measured times, not a count of instructions.
struct StageCost {
  std::string_view name;  ///< name of the stage as in Engine::stages(); stages of the display: compound, compress,
                          ///< smooth, scan_convert
  double operations = 0;  ///< single-precision and 32-bit integer operations; a multiply-add counts as two
  double bytes = 0;       ///< bytes read and written, each counted once, as with an unlimited cache
};

/// Returns the work of the stages of the `cpu` engine and the display, without stages whose cost depends on the scene's
/// shape (contact). The settings must be valid for the probe.
std::vector<StageCost> frameCost(const Probe& probe, const ImagingSettings& settings, const AcousticScene& scene);

}  // namespace insonate
