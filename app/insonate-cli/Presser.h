#pragma once

#include "PressOptions.h"

#include <insonate/simulator/Imager.h>
#include <insonate/simulator/PressedTissue.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace insonate::cli {

/// Compresses tissue at each pose of a path as the command-line options say.
class Presser {
 public:
  static Result<Presser> make(const ImagingSetup& setup, PressPlan plan);

  /// Moves each pose to where the probe's face touches the skin, if the plan compresses. Fails if there is no skin.
  static Result<std::vector<Transform>> onSkin(const PressPlan& plan, const LabelMap& labels, const ImagingSetup& setup,
                                               const std::vector<Transform>& path);
  /// Maximum distance by which the probe may go deeper than its pose.
  static double reach_mm(const PressPlan& plan);

  /// Compresses the tissue at a pose. Fails if there is no skin, or if the probe's face would enter bone.
  Result<void> press(const AcousticScene& scene, const Transform& patientFromProbe);

  const Transform& pose() const { return tissue_.pose(); }
  const PlaneDisplacement& displacement() const { return tissue_.deformation().displacement; }
  /// Returns the displacement, or zeros over the image plane if nothing moved; never empty.
  PlaneDisplacement field() const;
  /// Returns force_N, indent_mm and lumens. Without a deformation model, numbers are null and lumens are empty.
  nlohmann::json report() const;
  /// Returns sentences about the last pose; they begin in lower case.
  std::vector<std::string> warnings() const;

 private:
  Presser(PressedTissue tissue, const ImagingSetup& setup, PressPlan plan)
      : tissue_(std::move(tissue)), setup_(&setup), plan_(std::move(plan)) {}
  bool givesWay() const { return plan_.mechanics.model != kNoDeformation; }

  PressedTissue tissue_;
  const ImagingSetup* setup_;
  PressPlan plan_;
};

}  // namespace insonate::cli
