#pragma once

#include <insonate/procedure/AttemptRecording.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace insonate::review {

/// State of both hands at any time of a recording. One stretch, about a second, is unpacked when the time moves to
/// another stretch, wherever it lies. Not for concurrent use of one object.
class ReplayReader {
 public:
  explicit ReplayReader(std::shared_ptr<const AttemptRecording> recording) : recording_(std::move(recording)) {}

  /// The last sample until then, or the first of all; none where its stretch is damaged.
  std::optional<AttemptSample> at(std::int64_t time_us);

  /// Stretches that were unpacked so far.
  int unpacked() const { return unpacked_; }

 private:
  const Stretch* stretch(std::size_t index);
  std::optional<AttemptSample> first();

  std::shared_ptr<const AttemptRecording> recording_;
  std::optional<std::size_t> index_;
  std::optional<Stretch> stretch_;
  int unpacked_ = 0;
};

}  // namespace insonate::review
