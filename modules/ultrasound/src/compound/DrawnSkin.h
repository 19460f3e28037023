#pragma once

#include "model/Contact.h"
#include "scene/TissueField.h"

#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Needle.h>

#include <vector>

namespace insonate {

/// The rule for contact (model/Contact.h) as a displacement that is the same for all steering angles of a linear probe.
/// An engine draws skin to the face along its scanlines. At each steering angle, it would therefore draw the same
/// tissue to a different position, and a compounded image would show a boundary near a gap twice. This class draws
/// tissue along the axis of the probe instead.
class DrawnSkin {
 public:
  /// Allocates the memory for frames without compression. `maxSteering_deg`: largest angle to either side.
  void prepare(const Probe& probe, const ImagingSettings& settings, double maxSteering_deg);

  /// Finds the gap between face and skin, and draws the tissue to the face.
  void find(const TissueField& field, const Transform& patientFromProbe, const PlaneDisplacement& displacement);

  /// Returns the displacement of the last find(), with the motion of the tissue to the face.
  const PlaneDisplacement& displacement() const { return drawn_; }
  /// Returns Contact::strength at a scanline's origin, from the last find().
  float strength(int scanline) const { return strength_[scanline]; }
  /// Moves a needle, rigidly, by the distance by which the last find() draws the tissue at its tip.
  Needle moved(const Needle& needle, const Transform& patientFromProbe) const;

 private:
  void setLattice(const PlaneDisplacement& displacement);
  double gapAt(double x_mm) const;

  double half_mm_ = 0, reach_mm_ = 0, depth_mm_ = 0, sliceSd_mm_ = 1;
  std::vector<Vec3> origins_;  ///< origin of each scanline
  std::vector<float> strength_, gap_mm_;
  std::vector<double> pulledShare_;  ///< share of the gap by which tissue moves, by row of drawn_
  PlaneDisplacement drawn_;
};

}  // namespace insonate
