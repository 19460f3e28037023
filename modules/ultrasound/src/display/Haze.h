#pragma once

#include "DisplayPlan.h"
#include "FaceEchoes.h"
#include "Plane.h"

namespace insonate::display {

/// Echoes that belong elsewhere, seen where little else is: in lumens and shadows.
/// - *Reverberation of walls*: a tail of the echoes above, which fades over one to three millimeters.
/// - *Reverberation of strong reflectors*: bone and calcium shine on for many millimeters into their own shadow.
/// - *Side lobes*: a share of the echoes beside, at the same depth.
/// - *Between face and tissue*: the echoes of half the depth come again at the full one, since they went there and back
///   twice. Behind bone this is most of what there is.
/// The last two are smeared laterally. All of it drifts in strength from place to place: which echoes meet in phase
/// depends on the probe's own structure, so that the pattern stays with the probe.
class Haze {
 public:
  Haze(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan);

  /// Computes the haze from the mean power of each block, and that with strong echoes included. `face` gives the loss
  /// at lifted ends; null without.
  void follow(Plane& blockPower, Plane& strongPower, const FaceEchoes* face);
  /// Power in a block; 0 before follow().
  const float* row(int block) const { return haze_.row(block); }

 private:
  void smear(const Plane& blockPower, const float* contact, int block);

  const DisplayPlan* plan_;
  Plane tail_, grain_, longTail_, haze_, drift_;
  Plane smeared_;                ///< one row
  std::vector<float> smearing_;  ///< [block] share that goes on to the next scanline
};

}  // namespace insonate::display
