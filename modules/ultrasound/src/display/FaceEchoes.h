#pragma once

#include "DisplayPlan.h"
#include "Plane.h"
#include "ReceiveKernels.h"

namespace insonate::display {

/// Echoes that a probe's own face adds to an image. The transmitted pulse rings in the elements while they receive
/// already (main bang), and goes to and fro in the lens: bright bands in the first 2 mm, the same in all frames, a
/// little different from element to element. Where the skin does not touch the face, air reflects nearly everything:
/// the lens rings on, and little comes back from the tissue, a dark strip below bright bands.
///
/// No measurement of either was found. The time constants are chosen as real images show them; levels and strips are
/// settings.
class FaceEchoes {
 public:
  FaceEchoes(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan);

  /// Share of the amplitude that each scanline keeps; null where the whole face touches the skin.
  const float* contact() const { return lifts_ ? contact_.data() : nullptr; }
  /// Adds the ringing to a row of power.
  void addTo(float* power, int row, float rowGain) const;

 private:
  void findContact(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid);
  void findRinging(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid);

  bool lifts_ = false;
  int columns_;
  Plane line_, lack_;                     ///< one row each: power of the ringing, share of the face that is lifted
  std::vector<float> contact_;            ///< [scanline]
  std::vector<float> touching_, lifted_;  ///< [row] power; shorter than the image where nothing rings any more
};

}  // namespace insonate::display
