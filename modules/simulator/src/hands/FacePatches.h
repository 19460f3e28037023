#pragma once

#include "hand/SkinSurface.h"

#include <insonate/haptics/LocalModel.h>
#include <insonate/simulator/LiveImaging.h>

namespace insonate {

/// The skin before a probe's face as the servo feels it: flat patches that follow the probe, as stiff as the tissue's
/// last solution says. For one thread; nothing is allocated.
class FacePatches {
 public:
  static constexpr int kCount = 3;  ///< across the face

  /// Discards everything learned, for another patient or other tissue.
  void reset() { *this = {}; }

  /// Adds one solution: pose of the face, indentation and force. Solutions that are not at rest, which exaggerate, are
  /// left out.
  void learn(const SkinSurface& skin, const ProbeFace& face, const Transform& patientFromProbe, const LivePress& press);

  /// Patches before a face at this pose.
  void show(const SkinSurface& skin, const ProbeFace& face, const Transform& patientFromProbe, LocalModel& model) const;

 private:
  struct Law {
    double k1_Npmm = 0.06, k2_Npmm2 = 0.008;  ///< of each patch; a neck's, until something has been solved
  };

  Law law_;
  double higher_mm_ = 0;  ///< the tissue's first touch, above the averaged skin
  double before_mm_ = 0, before_N_ = 0;
  double steeper_ = 1.5;  ///< slope of force over depth, to force over depth
};

}  // namespace insonate
