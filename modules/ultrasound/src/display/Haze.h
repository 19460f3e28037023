#pragma once

#include "DisplayPlan.h"
#include "FaceEchoes.h"
#include "Plane.h"

namespace insonate::display {

/// Haze: weak echoes displayed at a wrong place, visible where few other echoes are: in lumens and shadows.
/// - *Reverberation of walls*: a tail below the echoes of walls, which fades over one to three millimeters.
/// - *Reverberation of strong reflectors*: bone and calcium leak for many millimeters into their own shadow.
/// - *Side lobes*: a share of the lateral echoes at the same depth.
/// - *Between face and tissue*: the echoes of half the depth appear again at the full depth after a second round trip.
///   Behind bone they are most of the image.
/// The haze by side lobes and second round trips is spread laterally. The strength of all haze varies from place to
/// place: the probe's own structure determines which echoes arrive in phase, so that the pattern moves with the probe.
class Haze {
 public:
  Haze(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan);

  /// Computes the haze of a frame from the mean power of each block of rows: `blockPower` with strong echoes limited,
  /// `strongPower` with strong echoes in full. `face` gives the loss where the face is lifted off the skin; may be
  /// null.
  void follow(Plane& blockPower, Plane& strongPower, const FaceEchoes* face);
  /// Returns the power of the haze of each scanline in a block of rows; 0 before follow().
  const float* row(int block) const { return haze_.row(block); }

 private:
  void smear(const Plane& blockPower, const float* contact, int block);

  const DisplayPlan* plan_;
  Plane tail_, grain_, longTail_, haze_, drift_;
  Plane smeared_;                ///< a single row: haze by side lobes and second round trips
  std::vector<float> smearing_;  ///< [block] share of the laterally spread haze that passes on to the next scanline
};

}  // namespace insonate::display
