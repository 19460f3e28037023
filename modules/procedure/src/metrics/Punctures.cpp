#include "metrics/Punctures.h"

namespace insonate::metrics {

void Punctures::beginPass() {
  front_mm_.reset(), back_mm_.reset();
  inside_ = false;
}

bool Punctures::enter(double depth_mm) {
  if (inside_) return false;
  inside_ = true;
  if (front_mm_) return false;
  front_mm_ = depth_mm, back_mm_.reset();
  ++count_;
  return true;
}

void Punctures::leave(double depth_mm) {
  // Without d1 the inward crossing was not seen. At a depth below d1, the tip has left beside its hole.
  if (!inside_ || !front_mm_) return;
  inside_ = false;
  if (back_mm_ || depth_mm < *front_mm_ - kTolerance_mm) return;
  back_mm_ = depth_mm;
  ++through_;
}

void Punctures::withdraw(bool inside) {
  inside_ = inside && front_mm_;
}

void Punctures::follow(double depth_mm) {
  if (inside_ && back_mm_ && depth_mm < *back_mm_ - kTolerance_mm) back_mm_.reset();
  if (!inside_ && front_mm_ && depth_mm < *front_mm_ - kTolerance_mm) front_mm_.reset(), back_mm_.reset();
}

}  // namespace insonate::metrics
