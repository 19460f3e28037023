#pragma once

#include "DisplayPlan.h"
#include "Plane.h"
#include "ReceiveKernels.h"

#include <optional>
#include <vector>

namespace insonate::display {

/// Echoes of the probe's own face, and the loss of echoes at an end of the face that is lifted off the skin. The
/// transmitted pulse rings in the elements while they already receive (main bang), and reverberates in the lens. This
/// gives bright bands in the first 2 mm, the same in all frames and slightly different between elements. If the skin
/// does not touch the face, air reflects nearly everything: the lens rings slightly longer, and these elements neither
/// transmit nor receive. The amplitude of a scanline is multiplied by the touching share of its transmit aperture and
/// by that of its receive aperture. Apertures grow with depth, so that the dark strip is sharp near the face, and
/// becomes blurred and narrower below.
///
/// No measurement of either effect was found. The time constants are fitted to real images; levels and strips are
/// settings.
class FaceEchoes {
 public:
  FaceEchoes(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan);

  /// Returns the share of the amplitude that each scanline keeps in a block of rows, because a part of the face does
  /// not touch the skin; null if the whole face touches.
  const float* contact(int block) const { return contact_ ? contact_->row(block) : nullptr; }
  /// Adds the power of the ringing to a row of echo power.
  void addTo(float* power, int row, float rowGain) const;

 private:
  void findContact(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan, const BeamGrid& grid);
  void findRinging(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid);

  int columns_;
  Plane line_, lack_;  ///< line_: power of each scanline's ringing; lack_: share of the ringing that is as in air
  std::optional<Plane> contact_;          ///< share of the amplitude that each scanline keeps, [block][scanline]
  std::vector<float> touching_, lifted_;  ///< power of the ringing in each row, where the face touches the skin and
                                          ///< where the face is lifted; ends where the ringing ends
};

}  // namespace insonate::display
