#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstdint>

namespace insonate {

/// Kalman filter of a pose with constant velocity. It follows a constant velocity without delay. The assumed
/// acceleration grows with the speed, so that a hand at rest is smoothed more than a moving hand. Frames: camera frame,
/// mm, rad. Allocates nothing.
class HandFilter {
 public:
  /// Longest time into the future for which predictedAt() extrapolates.
  static constexpr std::int64_t kMaxPrediction_ns = 50'000'000;

  /// Begins anew at a pose, at rest.
  void reset(const Transform& cameraFromBody, std::int64_t time_ns);
  /// Adds a measured pose with its covariance (as in BodyPose). `time_ns` must be later than that of the measurement
  /// before.
  void update(const Transform& measured, const std::array<double, 36>& covariance, std::int64_t time_ns);

  /// Pose and velocities at the time of the latest measurement.
  const Transform& cameraFromBody() const { return pose_; }
  Vec3 velocity_mmps() const { return {velocity_[0], velocity_[1], velocity_[2]}; }
  Vec3 angularVelocity_radps() const { return {velocity_[3], velocity_[4], velocity_[5]}; }
  std::int64_t time_ns() const { return time_ns_; }

  /// Returns the pose at another time, by the velocity; at most kMaxPrediction_ns after the latest measurement.
  Transform predictedAt(std::int64_t time_ns) const;

 private:
  using Block = std::array<double, 36>;
  Transform pose_;
  std::array<double, 6> velocity_{};
  Block poses_{}, mixed_{}, velocities_{};  ///< covariance of pose; of pose and velocity; of velocity
  std::int64_t time_ns_ = 0;
};

}  // namespace insonate
