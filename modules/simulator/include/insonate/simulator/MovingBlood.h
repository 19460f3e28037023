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
  /// `labels` is the label map of the case; see BloodFlowModel.
  explicit MovingBlood(std::span<const NamedVessel> vessels, const LabelMap* labels = nullptr)
      : model_(vessels, labels) {}

  /// Computes the velocities of the blood. Without a time, all vessels have their mean flow. `displacement` is that of
  /// the tissue in the image at this pose. The result stays valid until the next call. Allocates nothing after the
  /// first call while the heart rate stays the same.
  const BloodFlow& at(const Physiology& physiology, std::optional<double> time_s, const PlaneDisplacement& displacement,
                      const Transform& patientFromProbe) {
    computeVesselAreas(model_.vessels(), displacement, patientFromProbe, areas_);
    model_.at(physiology, time_s, areas_, flow_);
    return flow_;
  }

  /// Computes the velocities for images that follow each other: blood that a compression has expelled from a vein since
  /// the last call flows toward the heart. `interval_s` is the time since the last call; 0: the image follows no other,
  /// and nothing is known about earlier changes.
  const BloodFlow& next(const Physiology& physiology, std::optional<double> time_s,
                        const PlaneDisplacement& displacement, const Transform& patientFromProbe, double interval_s) {
    before_.swap(areas_);
    computeVesselAreas(model_.vessels(), displacement, patientFromProbe, areas_);
    if (before_.empty()) before_ = areas_;
    if (rates_perS_.empty())
      for (const std::vector<double>& areas : areas_) rates_perS_.emplace_back(areas.size(), 0.0);
    // The deformation of each image is not fully converged; averaging suppresses its changes.
    constexpr double kKept = 0.7;
    for (std::size_t v = 0; v < areas_.size(); ++v)
      for (std::size_t i = 0; i < areas_[v].size(); ++i) {
        double& rate_perS = rates_perS_[v][i];
        if (interval_s > 0)
          rate_perS += (1 - kKept) * ((areas_[v][i] - before_[v][i]) / interval_s - rate_perS);
        else
          rate_perS = 0;
      }
    model_.at(physiology, time_s, areas_, rates_perS_, flow_);
    return flow_;
  }

  /// Computes the velocities at another time, with the compression of the last call of at() or next().
  const BloodFlow& again(const Physiology& physiology, std::optional<double> time_s) {
    model_.at(physiology, time_s, areas_, rates_perS_, flow_);
    return flow_;
  }

  const BloodFlowModel& model() const { return model_; }

 private:
  BloodFlowModel model_;
  VesselAreas areas_, before_, rates_perS_;
  BloodFlow flow_;
};

}  // namespace insonate
