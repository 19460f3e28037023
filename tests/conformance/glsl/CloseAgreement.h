#pragma once

#include "conformance/Measure.h"
#include "conformance/glsl/CompactCases.h"

namespace insonate::test {

/// Accuracy of the shaders: far below the permitted error of engines, so that hardly a term can be missing from them.
inline constexpr double kCloseError = 0.001;
/// The same on a graphics card, whose arithmetic rounds differently: a few gates read the next entry of a table.
inline constexpr double kCloseErrorOnCard = 0.002;

/// Share of the truth's RMS, or 1 where only one of the two is silent or a number is missing.
inline double errorOf(const EnvelopeFrame& frame, const EnvelopeFrame& truth) {
  if (!allFinite(frame) || frame.amplitude.size() != truth.amplitude.size()) return 1;
  if (largest(truth) == 0) return largest(frame) == 0 ? 0 : 1;
  return relativeError(frame, truth);
}

}  // namespace insonate::test
