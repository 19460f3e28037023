#pragma once

#include "PressOptions.h"

#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/Imager.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace insonate::cli {

/// Computes the compression of tissue by the probe at each pose of a path, as given by the command line (PressPlan).
class Presser {
 public:
  static Result<Presser> make(const ImagingSetup& setup, PressPlan plan);

  /// Returns the poses of `path`, moved to where the probe's face touches the skin if the plan has a force or
  /// indentation. Fails if there is no skin.
  static Result<std::vector<Transform>> onSkin(const PressPlan& plan, const LabelMap& labels, const ImagingSetup& setup,
                                               const std::vector<Transform>& path);
  /// Returns the maximum distance by which compression may move the probe deeper than its pose.
  static double reach_mm(const PressPlan& plan);

  /// Compresses the tissue at a pose. Fails if there is no skin, or if the probe's face would enter bone.
  Result<void> press(const AcousticScene& scene, const Transform& patientFromProbe);

  /// Computes the tissue with the probe's face at a pose, at a time in the cycles of heartbeat and breathing, s.
  void holdAt(const AcousticScene& scene, const Transform& patientFromProbe, double time_s);

  const Transform& pose() const { return tissue_.pose(); }
  const PlaneDisplacement& displacement() const { return tissue_.deformation().displacement; }
  /// Returns the tissue displacement, or zeros over the image plane if nothing moved; never empty.
  PlaneDisplacement field() const;
  /// Returns the last result as JSON: force_N, indent_mm and lumens. Without a deformation model, numbers are null and
  /// lumens are empty.
  nlohmann::json report() const;
  /// Returns warnings about the last pose, sentences that begin in lower case.
  std::vector<std::string> warnings() const;

 private:
  Presser(CompressedTissue tissue, const ImagingSetup& setup, PressPlan plan)
      : tissue_(std::move(tissue)), setup_(&setup), plan_(std::move(plan)) {}
  bool givesWay() const { return plan_.mechanics.model != kNoDeformation; }

  CompressedTissue tissue_;
  const ImagingSetup* setup_;
  PressPlan plan_;
};

}  // namespace insonate::cli
