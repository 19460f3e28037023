#pragma once

#include <insonate/flow/BloodFlowModel.h>

#include <optional>
#include <span>

namespace insonate {

/// Returns the velocity of undeformed tissue relative to a probe that has moved between two poses, in the probe frame
/// of the later pose, in the middle of the image at this depth. Zero if no time has passed.
inline Vec3 tissueVelocity_mmps(const Transform& earlier, const Transform& later, double seconds, double depth_mm) {
  const Vec3 point{0, 0, depth_mm};
  return seconds > 0 ? (point - inverted(earlier) * (later * point)) / seconds : Vec3{};
}

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
