#include "metrics/ProbeWork.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::metrics {
namespace {

constexpr std::int64_t kApart_us = 200'000;

/// Angle between two rotations: |A - B| (Frobenius) is 2 sqrt(2) sin(angle / 2), exact for small ones, too.
double angleBetween_deg(const Mat3& a, const Mat3& b) {
  double squares = 0;
  for (int c = 0; c < 3; ++c) {
    const Vec3 d = a.column[c] - b.column[c];
    squares += dot(d, d);
  }
  return 2 * std::asin(std::min(1.0, std::sqrt(squares / 8))) * 180 / std::numbers::pi;
}

}  // namespace

void Movements::follow(std::int64_t time_us, double speed) {
  if (speed <= limit_) return;
  if (!fast_us_ || time_us - *fast_us_ > kApart_us) ++count_;
  fast_us_ = time_us;
}

void ProbeWork::follow(std::int64_t time_us, const std::optional<Transform>& patientFromProbe, double force_N,
                       bool counting) {
  counted_ |= counting && patientFromProbe;
  if (!patientFromProbe) {
    size_ = 0;
    last_mm_.reset();
    return;
  }
  held_ = true;
  move({time_us, *patientFromProbe});
  walk(patientFromProbe->offset, counting);
  if (force_N <= 0) return;
  forceSum_N_ += force_N, forceMax_N_ = std::max(forceMax_N_, force_N);
  ++pressed_;
}

void ProbeWork::move(const Place& place) {
  const auto recent = [&](std::size_t i) -> Place& { return recent_[(begin_ + i) % recent_.size()]; };
  if (size_ == recent_.size()) ++begin_, --size_;
  recent(size_++) = place;
  while (size_ > 1 && place.time_us - recent(1).time_us >= kSpeed_us) ++begin_, --size_;
  const Place& before = recent(0);
  const double time_s = static_cast<double>(place.time_us - before.time_us) * 1e-6;
  if (place.time_us - before.time_us < kSpeed_us) return;
  translations_.follow(place.time_us, norm(place.patientFromProbe.offset - before.patientFromProbe.offset) / time_s);
  rotations_.follow(place.time_us,
                    angleBetween_deg(place.patientFromProbe.linear, before.patientFromProbe.linear) / time_s);
}

void ProbeWork::walk(Vec3 at_mm, bool counting) {
  if (!counting || !last_mm_) {
    last_mm_ = at_mm;
    return;
  }
  const double by_mm = norm(at_mm - *last_mm_);
  if (by_mm < kStep_mm) return;
  path_mm_ += by_mm;
  last_mm_ = at_mm;
}

std::optional<double> ProbeWork::path_mm() const {
  return counted_ ? std::optional(path_mm_) : std::nullopt;
}
std::optional<int> ProbeWork::translations() const {
  return held_ ? std::optional(translations_.count()) : std::nullopt;
}
std::optional<int> ProbeWork::rotations() const {
  return held_ ? std::optional(rotations_.count()) : std::nullopt;
}
std::optional<double> ProbeWork::forceMean_N() const {
  return pressed_ ? std::optional(forceSum_N_ / static_cast<double>(pressed_)) : std::nullopt;
}
std::optional<double> ProbeWork::forceMax_N() const {
  return pressed_ ? std::optional(forceMax_N_) : std::nullopt;
}

}  // namespace insonate::metrics
