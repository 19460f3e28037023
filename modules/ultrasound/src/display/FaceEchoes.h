#pragma once

#include "DisplayPlan.h"
#include "Plane.h"
#include "ReceiveKernels.h"

#include <optional>
#include <vector>

namespace insonate::display {

/// Echoes of a probe's own face in an image, and the loss of echoes at a lifted end of it. The transmitted pulse rings
/// in the elements while they already receive (main bang), and reverberates in the lens: bright bands in the first 2
/// mm, the same in all frames, slightly different between elements. Where the skin does not touch the face, air
/// reflects nearly everything: the lens rings a little longer, and these elements neither send nor receive. A scanline
/// keeps the share of its apertures that touches, on transmit times on receive. Apertures grow with the depth, so that
/// the dark strip is sharp near the face and blurs and narrows below.
///
/// No measurement of either was found. The time constants are chosen by real images; levels and strips are settings.
class FaceEchoes {
 public:
  FaceEchoes(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan);

  /// Share of the amplitude that each scanline keeps in a block of rows; null where the whole face touches the skin.
  const float* contact(int block) const { return contact_ ? contact_->row(block) : nullptr; }
  /// Adds the ringing to a row of power.
  void addTo(float* power, int row, float rowGain) const;

 private:
  void findContact(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan, const BeamGrid& grid);
  void findRinging(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid);

  int columns_;
  Plane line_, lack_;                     ///< one row each: power of the ringing, share of it that is as in air
  std::optional<Plane> contact_;          ///< [block][scanline]
  std::vector<float> touching_, lifted_;  ///< [row] power; shorter than the image where nothing rings any more
};

}  // namespace insonate::display
