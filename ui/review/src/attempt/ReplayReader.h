#pragma once

#include <insonate/procedure/AttemptRecording.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace insonate::review {

/// Returns the state of probe and needle at any time of a recording. Recordings are stored in blocks of about a second;
/// a block is decompressed when a time within the block is requested. One object must not be used by several threads at
/// once.
class ReplayReader {
 public:
  explicit ReplayReader(std::shared_ptr<const AttemptRecording> recording) : recording_(std::move(recording)) {}

  /// Returns the last sample at or before this time, else the first sample of all; empty if its block is damaged.
  std::optional<AttemptSample> at(std::int64_t time_us);

  /// Number of blocks unpacked so far.
  int unpacked() const { return unpacked_; }

 private:
  const RecordingSegment* segment(std::size_t index);
  std::optional<AttemptSample> first();

  std::shared_ptr<const AttemptRecording> recording_;
  std::optional<std::size_t> index_;
  std::optional<RecordingSegment> stretch_;
  int unpacked_ = 0;
};

}  // namespace insonate::review
