#include "ReplayReader.h"

#include <algorithm>

namespace insonate::review {

const RecordingSegment* ReplayReader::segment(std::size_t index) {
  if (index_ != index) {
    index_ = index, ++unpacked_;
    auto read = recording_->segment(index);
    stretch_ = read ? std::optional(std::move(*read)) : std::nullopt;
  }
  return stretch_ ? &*stretch_ : nullptr;
}

std::optional<AttemptSample> ReplayReader::at(std::int64_t time_us) {
  if (recording_->segmentCount() == 0) return std::nullopt;
  // An event may begin a stretch before its first sample: then the stretch before contains the last sample.
  for (std::size_t index = recording_->segmentAt(time_us);; --index) {
    const RecordingSegment* found = segment(index);
    if (!found) return std::nullopt;
    const auto after = std::ranges::upper_bound(found->samples, time_us, {}, &QuantizedSample::time_us);
    if (after != found->samples.begin()) return dequantize(*std::prev(after));
    if (index == 0) return first();
  }
}

/// Moves past stretches that contain only events.
std::optional<AttemptSample> ReplayReader::first() {
  for (std::size_t index = 0; index < recording_->segmentCount(); ++index) {
    const RecordingSegment* found = segment(index);
    if (!found) return std::nullopt;
    if (!found->samples.empty()) return dequantize(found->samples.front());
  }
  return std::nullopt;
}

}  // namespace insonate::review
