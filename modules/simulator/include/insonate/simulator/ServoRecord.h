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

/// What the servo does not know of a tick.
struct TickContext {
  std::int64_t time_us = 0;  ///< since the recording began
  std::array<bool, 2> present{};
  double pictureDepth_mm = 0;
  bool aspirating = false;
  Transform restFromPatient;  ///< of LocalModel
};

/// A tick of the servo as a recording keeps it. Distances to artery and lung are those of the grid, where it knows any
/// within 200 mm; `veins` are the centre lines of the case's veins, in tissue at rest. Neither waits nor allocates.
AttemptSample sampleOf(const ServoOutput& output, const TickContext& context, const TissueGrid* grid,
                       std::span<const CentreLine> veins, const VesselNames& vessels) noexcept;
/// The skin's normal comes from the grid, too. Time is the context's.
AttemptEvent eventOf(const NeedleEvent& event, const TickContext& context, const TissueGrid* grid,
                     std::span<const CentreLine> veins, const VesselNames& vessels) noexcept;

/// Where a probe's picture shows something; the slice's half thickness is that at the elevation focus, at the probe's
/// default frequency: half the width at half maximum, as in Probe.
PictureField pictureFieldOf(const Probe& probe);

}  // namespace insonate
