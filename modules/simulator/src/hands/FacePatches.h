#pragma once

#include "hand/SkinSurface.h"

#include <insonate/haptics/LocalModel.h>
#include <insonate/simulator/LiveImaging.h>

namespace insonate {

/// The skin before a probe's face as the servo feels it: flat patches that follow the probe, with the stiffness of the
/// tissue's last solution. For one thread; allocates nothing.
class FacePatches {
 public:
  static constexpr int kCount = 3;  ///< patches along the face

  /// Discards everything learned, for another patient or other tissue.
  void reset() { *this = {}; }

  /// Adds one solution: pose of the face, indentation and force. Solutions that have not converged and exceed a
  /// plausible force are left out.
  void learn(const SkinSurface& skin, const ProbeFace& face, const Transform& patientFromProbe, const LivePress& press);

  /// Writes the patches before a face at this pose into `model`.
  void show(const SkinSurface& skin, const ProbeFace& face, const Transform& patientFromProbe, LocalModel& model) const;

 private:
  struct Law {
    double k1_Npmm = 0.06, k2_Npmm2 = 0.008;  ///< force law of each patch; a neck's values until a solution is known
  };

  Law law_;
  double higher_mm_ = 0;  ///< height of first contact above the averaged skin
  double before_mm_ = 0, before_N_ = 0;
  double steeper_ = 1.5;  ///< ratio of the force's slope to force over depth
};

}  // namespace insonate
