#pragma once

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/AttemptImages.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace insonate::video {

/// Renders the images of an attempt, and returns the former image again while the image is frozen.
class ReplayImages {
 public:
  explicit ReplayImages(AttemptImages pictures);

  /// Returns the image of a time; `sample`: the last sample at this time. Null: no probe is held. The image stays valid
  /// until the next call.
  Result<const LiveFrame*> at(std::int64_t time_us, const std::optional<AttemptSample>& sample);

 private:
  AttemptImages pictures_;
  std::shared_ptr<const LiveFrame> last_{};
  bool wasFrozen_ = false;
};

}  // namespace insonate::video
