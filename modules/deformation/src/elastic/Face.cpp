#include "elastic/Face.h"

#include <algorithm>
#include <cmath>

namespace insonate::elastic {

Face::Face(const ProbeFace& face)
    : half_(static_cast<float>(face.width_mm) / 2), radius_(static_cast<float>(face.radius_mm)) {
  edgeAngle_ = radius_ > 0 ? std::asin(std::min(half_ / radius_, 0.99f)) : 0;
  edgeZ_ = radius_ > 0 ? radius_ * (std::cos(edgeAngle_) - 1) : 0;
}

Face::Point Face::at(float x_mm) const {
  const float x = std::abs(x_mm), sign = x_mm < 0 ? -1.0f : 1.0f;
  if (x <= half_) {
    if (radius_ <= 0) return {true, 0, 0};
    const float rest = std::sqrt(radius_ * radius_ - x * x);
    return {true, rest - radius_, -x_mm / rest};
  }
  // An arc that goes on from the edge, until it is steeper than 60 degrees.
  const float sine = std::sin(edgeAngle_) + (x - half_) / kEndRadius_mm;
  if (sine > 0.87f) return {};
  const float cosine = std::sqrt(1 - sine * sine);
  return {true, edgeZ_ - kEndRadius_mm * (std::cos(edgeAngle_) - cosine), -sign * sine / cosine};
}

}  // namespace insonate::elastic
