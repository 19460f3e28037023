#pragma once

#include "PressOptions.h"

#include <insonate/simulator/Imager.h>
#include <insonate/simulator/PressedTissue.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace insonate::cli {

/// Does to the probe of one pose after the other what the command line says.
class Presser {
 public:
  static Result<Presser> make(const ImagingSetup& setup, PressPlan plan);

  /// A pose that is to be moved starts where the face touches. Fails where there is no skin.
  static Result<std::vector<Transform>> onSkin(const PressPlan& plan, const LabelMap& labels, const ImagingSetup& setup,
                                               const std::vector<Transform>& path);
  /// Distance by which the probe may go deeper than its pose.
  static double reach_mm(const PressPlan& plan);

  /// Fails where there is no skin, and where the face would go through bone.
  Result<void> press(const AcousticScene& scene, const Transform& patientFromProbe);

  const Transform& pose() const { return tissue_.pose(); }
  const PlaneDisplacement& displacement() const { return tissue_.deformation().displacement; }
  /// Never empty: where nothing moved, zeros over the plane of the picture.
  PlaneDisplacement field() const;
  /// force_N, indent_mm, lumens; null and empty where tissue does not give way.
  nlohmann::json report() const;
  /// About the last pose, sentences that begin in lower case.
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
