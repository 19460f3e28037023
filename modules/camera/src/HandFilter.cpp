#include "Rigid.h"

#include <insonate/camera/HandFilter.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using camera::Motion;
using Block6 = camera::Matrix<6, 6>;

// Spectral density of the acceleration of a hand at rest and in motion, mm^2/s^3 and rad^2/s^3.
constexpr double kRest_mm = 60, kMotion_mm = 2e5, kRest_rad = 0.02, kMotion_rad = 40;
constexpr double kFast_mmps = 120, kFast_radps = 1.2;
constexpr double kStartVelocity_mmps = 200, kStartVelocity_radps = 2;
constexpr double kSurprise = 25;  // of the squared Mahalanobis distance with 6 degrees of freedom: 1 in 3000

struct Density {
  double position, rotation;
  double of(int axis) const { return axis < 3 ? position : rotation; }
};

struct State {
  Block6 poses, mixed, velocities;
};

State predicted(State s, double dt, const Density& density) {
  const Block6 back = camera::transposed(s.mixed);
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) {
      s.poses(r, c) += dt * (s.mixed(r, c) + back(r, c)) + dt * dt * s.velocities(r, c);
      s.mixed(r, c) += dt * s.velocities(r, c);
    }
  for (int i = 0; i < 6; ++i) {
    const double q = density.of(i);
    s.poses(i, i) += q * dt * dt * dt / 3, s.mixed(i, i) += q * dt * dt / 2, s.velocities(i, i) += q * dt;
  }
  return s;
}

}  // namespace

void HandFilter::reset(const Transform& cameraFromBody, std::int64_t time_ns) {
  pose_ = cameraFromBody, time_ns_ = time_ns;
  velocity_ = {}, poses_ = {}, mixed_ = {}, velocities_ = {};
  for (std::size_t i = 0; i < 6; ++i) {
    const double v = i < 3 ? kStartVelocity_mmps : kStartVelocity_radps;
    poses_[7 * i] = i < 3 ? 1 : 1e-3, velocities_[7 * i] = v * v;
  }
}

Transform HandFilter::predictedAt(std::int64_t time_ns) const {
  const double dt = 1e-9 * double(std::min(time_ns - time_ns_, kMaxPrediction_ns));
  Motion motion;
  for (int i = 0; i < 6; ++i) motion[i] = dt * velocity_[std::size_t(i)];
  return camera::movedBy(pose_, motion);
}

void HandFilter::update(const Transform& measured, const std::array<double, 36>& covariance, std::int64_t time_ns) {
  const double dt = 1e-9 * double(time_ns - time_ns_);
  if (!(dt > 0)) return;
  Motion path;
  for (int i = 0; i < 6; ++i) path[i] = dt * velocity_[std::size_t(i)];
  const Transform expected = camera::movedBy(pose_, path);
  const Motion innovation = camera::motionBetween(expected, measured);
  const double speed = std::min(1.0, norm(velocity_mmps()) / kFast_mmps + norm(angularVelocity_radps()) / kFast_radps);
  Density density{kRest_mm + kMotion_mm * speed * speed, kRest_rad + kMotion_rad * speed * speed};
  const State before{{poses_}, {mixed_}, {velocities_}};
  State state = predicted(before, dt, density);
  const auto spread = [&] {
    Block6 sum = state.poses;
    sum += Block6{covariance};
    return sum;
  };
  const Motion weighted = camera::solved(spread(), innovation);
  if ((camera::transposed(innovation) * weighted)[0] > kSurprise) {
    density = {kMotion_mm, kMotion_rad};
    state = predicted(before, dt, density);
  }
  const Block6 inverse = camera::inverted(spread());
  const Block6 gain = state.poses * inverse, velocityGain = camera::transposed(state.mixed) * inverse;
  pose_ = camera::movedBy(expected, gain * innovation);
  const Motion faster = velocityGain * innovation;
  for (int i = 0; i < 6; ++i) velocity_[std::size_t(i)] += faster[i];
  const auto minus = [](Block6 a, const Block6& b) {
    a += b * -1;
    return a;
  };
  poses_ = minus(state.poses, gain * state.poses).values;
  velocities_ = minus(state.velocities, velocityGain * state.mixed).values;
  mixed_ = minus(state.mixed, gain * state.mixed).values;
  time_ns_ = time_ns;
}

}  // namespace insonate
