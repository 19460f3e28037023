#include "ultrasound/FrameErrors.h"

#include <algorithm>
#include <cmath>

namespace insonate::bench {

void EnvelopeError::add(const EnvelopeFrame& frame, const EnvelopeFrame& truth) {
  for (std::size_t i = 0; i < truth.amplitude.size(); ++i) {
    const double t = truth.amplitude[i], d = frame.amplitude[i] - t;
    difference2_ += d * d, truth2_ += t * t;
  }
}

double EnvelopeError::percent() const {
  return truth2_ > 0 ? 100 * std::sqrt(difference2_ / truth2_) : 0;
}

EnvelopeFrame resampled(const EnvelopeFrame& frame, const BeamGrid& from, const BeamGrid& to) {
  EnvelopeFrame out;
  out.resize(to.scanlines(), to.samples(), 1);
  const auto before = [](double at, int size) { return std::clamp(static_cast<int>(at), 0, size - 2); };
  for (int k = 0; k < to.samples(); ++k)
    for (int l = 0; l < to.scanlines(); ++l) {
      const Vec3 point_mm = to.origin(l) + to.direction(l) * to.range_mm(k);
      const BeamGrid::Location at = from.locate(point_mm.x, point_mm.z);
      const int line = before(at.scanline, frame.scanlines), sample = before(at.sample, frame.samples);
      const double x = std::clamp(at.scanline - line, 0.0, 1.0), z = std::clamp(at.sample - sample, 0.0, 1.0);
      const float* p = frame.look(0) + std::size_t(sample) * frame.scanlines + line;
      const float* q = p + frame.scanlines;
      out.amplitude[std::size_t(k) * to.scanlines() + l] =
          static_cast<float>((1 - z) * ((1 - x) * p[0] + x * p[1]) + z * ((1 - x) * q[0] + x * q[1]));
    }
  return out;
}

}  // namespace insonate::bench
