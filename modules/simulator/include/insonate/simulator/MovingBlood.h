#pragma once

#include <insonate/flow/BloodFlowModel.h>

#include <optional>
#include <span>

namespace insonate {

/// Blood flow of a case in its present state: time, blood pressures and compression by the probe. One object must not
/// be used concurrently.
class MovingBlood {
 public:
  explicit MovingBlood(std::span<const NamedVessel> vessels) : model_(vessels) {}

  /// Computes the velocities of the blood. Without a time, all vessels have their mean flow. `displacement` is that of
  /// the tissue in the image at this pose. The result stays valid until the next call. Allocates nothing after the
  /// first call while the heart rate stays the same.
  const BloodFlow& at(const Physiology& physiology, std::optional<double> time_s, const PlaneDisplacement& displacement,
                      const Transform& patientFromProbe) {
    computeVesselAreas(model_.vessels(), displacement, patientFromProbe, areas_);
    model_.at(physiology, time_s, areas_, flow_);
    return flow_;
  }

  const BloodFlowModel& model() const { return model_; }

 private:
  BloodFlowModel model_;
  VesselAreas areas_;
  BloodFlow flow_;
};

}  // namespace insonate
