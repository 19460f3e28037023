#pragma once

#include <insonate/haptics/HapticServo.h>
#include <insonate/haptics/TissueGrid.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptSample.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/simulator/VesselLocator.h>
#include <insonate/ultrasound/Probe.h>

#include <array>
#include <cstdint>
#include <span>

namespace insonate {

class SkinSurface;

/// Values of a recorded sample (AttemptSample) that ServoOutput, the output of the force loop, does not contain.
struct TickContext {
  std::int64_t time_us = 0;  ///< time since the recording began
  std::array<bool, 2> present{};
  double imageDepth_mm = 0;
  bool aspirating = false;
  /// affine map from the present to the undeformed position of tissue near the needle's tip, as
  /// LocalModel::restFromPatient
  Transform restFromPatient;
};

/// Converts one tick of the force loop to a sample of a recording. Distances from the tip to artery and lung are taken
/// from `grid`, if they are below 200 mm. `veins` are the center lines of the case's veins in undeformed tissue.
/// Neither waits nor allocates.
AttemptSample makeSample(const ServoOutput& output, const TickContext& context, const TissueGrid* grid,
                         std::span<const CenterLine> veins, const VesselLocator& vessels) noexcept;
/// Converts a needle event of the force loop to an event of a recording at `context.time_us`. `skin`: undeformed skin
/// of the case; null: not computed yet. The normal of the skin is taken at the point where the line of the needle meets
/// the skin, as in NeedlePlacement; the recorded insertion angle therefore equals the angle that the user has set.
AttemptEvent makeEvent(const NeedleEvent& event, const TickContext& context, const SkinSurface* skin,
                       std::span<const CenterLine> veins, const VesselLocator& vessels) noexcept;

/// Returns the region that the image of a probe shows at the probe's default frequency.
ImageField imageFieldOf(const Probe& probe);

}  // namespace insonate
