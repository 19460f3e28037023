#include <insonate/deformation/FaceProfile.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr float kEndSine = 0.87f;  // sine of 60 degrees

}  // namespace

FaceProfile::FaceProfile(const ProbeFace& face)
    : half_(static_cast<float>(face.width_mm) / 2),
      radius_(static_cast<float>(face.radius_mm)),
      edgeSine_(radius_ > 0 ? std::min(half_ / radius_, 0.99f) : 0),
      edgeCosine_(std::sqrt(1 - edgeSine_ * edgeSine_)) {}

FaceProfile::Point FaceProfile::at(float x_mm) const {
  const float x = std::abs(x_mm);
  if (x <= half_) return {true, radius_ > 0 ? std::sqrt(radius_ * radius_ - x * x) - radius_ : 0};
  const float sine = edgeSine_ + (x - half_) / kEndRadius_mm;
  if (sine > kEndSine) return {};
  return {true, radius_ * (edgeCosine_ - 1) - kEndRadius_mm * (edgeCosine_ - std::sqrt(1 - sine * sine))};
}

float FaceProfile::reach_mm() const {
  return half_ + std::max(0.0f, kEndSine - edgeSine_) * kEndRadius_mm;
}

}  // namespace insonate
