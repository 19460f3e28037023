#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

namespace insonate::bench {

/// Differences of frames of one size, pooled: RMS of the difference over RMS of the truth, all looks.
class EnvelopeError {
 public:
  void add(const EnvelopeFrame& frame, const EnvelopeFrame& truth);
  double percent() const;

 private:
  double difference2_ = 0, truth2_ = 0;
};

/// First look of a frame on other beams of the same probe and depth, bilinear.
EnvelopeFrame resampled(const EnvelopeFrame& frame, const BeamGrid& from, const BeamGrid& to);

}  // namespace insonate::bench
