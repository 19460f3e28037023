#pragma once

#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string_view>
#include <vector>

namespace insonate {

/// Returns the distance between gates: the points of a scanline at which echoes are computed. The distance is the
/// largest multiple of the sample spacing at which at least 2.4 gates fit into the length of the pulse.
double gateDistance_mm(const Probe& probe, const ImagingSettings& settings);

/// Returns the value of `detail_mm` in AcousticScene::make() that suffices for this probe: 1.2 if its beam is at least
/// 1.2 mm wide, else 0.7.
double sceneDetail_mm(const Probe& probe, const ImagingSettings& settings);

/// Estimated computing cost of one stage of a frame, for comparison with measured times. The numbers follow from the
/// sizes of the grids by formula; they are not counts of executed instructions.
struct StageCost {
  std::string_view name;  ///< name of the stage as in Engine::stages(); stages of the display: compound, compress,
                          ///< smooth, scan_convert
  double operations = 0;  ///< single-precision and 32-bit integer operations; a multiply-add counts as two
  double bytes = 0;       ///< bytes read and written, each counted once as if the cache were unlimited
};

/// Returns the costs of the stages of the engine `cpu` and of the display. The stage `contact`, whose cost depends on
/// the shape of the skin, is left out. The settings must be valid for the probe.
std::vector<StageCost> frameCost(const Probe& probe, const ImagingSettings& settings, const AcousticScene& scene);

}  // namespace insonate
