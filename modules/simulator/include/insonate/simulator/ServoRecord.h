#pragma once

#include <insonate/haptics/HapticServo.h>
#include <insonate/haptics/TissueGrid.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptSample.h>
#include <insonate/segmentation/CentreLine.h>
#include <insonate/simulator/VesselNames.h>
#include <insonate/ultrasound/Probe.h>

#include <array>
#include <cstdint>
#include <span>

namespace insonate {

class SkinSurface;

/// Time and tissue of a tick, which the servo does not know.
struct TickContext {
  std::int64_t time_us = 0;  ///< since the recording began
  std::array<bool, 2> present{};
  double pictureDepth_mm = 0;
  bool aspirating = false;
  Transform restFromPatient;  ///< LocalModel::restFromPatient
};

/// Returns a tick of the servo as a sample of a recording. Distances to artery and lung are those of the grid, if it
/// has any within 200 mm; `veins` are the center lines of the case's veins, in tissue at rest. Neither waits nor
/// allocates.
AttemptSample sampleOf(const ServoOutput& output, const TickContext& context, const TissueGrid* grid,
                       std::span<const CentreLine> veins, const VesselNames& vessels) noexcept;
/// Returns an event of the needle as an event of a recording, at the context's time. `skin`: skin of the case,
/// undeformed by the probe; null: not computed yet. The normal of the skin is taken at the point where the needle's
/// line meets the skin, as NeedleHand does, so that the insertion angle is the angle that the user had set.
AttemptEvent eventOf(const NeedleEvent& event, const TickContext& context, const SkinSurface* skin,
                     std::span<const CentreLine> veins, const VesselNames& vessels) noexcept;

/// Region that a probe's image shows, at its default frequency.
PictureField pictureFieldOf(const Probe& probe);

}  // namespace insonate
