#pragma once

#include "hand/SkinSurface.h"

#include <insonate/haptics/LocalModel.h>
#include <insonate/simulator/LiveImaging.h>

namespace insonate {

/// Skin in front of a probe's face as the force loop feels it: plane patches (SkinPatch) that follow the probe, with
/// the stiffness found by the last computed deformation. One object must be used on one thread only. Allocates nothing.
class FacePatches {
 public:
  static constexpr int kCount = 3;  ///< number of patches along the probe's face

  /// Discards the learned stiffness, for another patient or other tissue.
  void reset() { *this = {}; }

  /// Learns the stiffness from one computed deformation: pose, indentation and force. Deformations that have not
  /// converged and have an implausibly large force are ignored.
  void learn(const SkinSurface& skin, const ProbeFace& face, const Transform& patientFromProbe,
             const LiveDeformation& press);

  /// Writes the skin patches in front of a face at this pose into `model`.
  void show(const SkinSurface& skin, const ProbeFace& face, const Transform& patientFromProbe, LocalModel& model) const;

 private:
  struct Law {
    /// Force k1 d + k2 d^2 of each patch at indentation d; typical values of a neck until a solution is known.
    double k1_Npmm = 0.06, k2_Npmm2 = 0.008;
  };

  Law law_;
  double higher_mm_ = 0;  ///< height of the skin at first contact above the averaged SkinSurface
  double before_mm_ = 0, before_N_ = 0;
  double steeper_ = 1.5;  ///< ratio of the slope of the force to force over depth
};

}  // namespace insonate
