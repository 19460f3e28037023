#include "attempt/ReplayImages.h"

#include <utility>

namespace insonate::video {

ReplayImages::ReplayImages(AttemptImages pictures) : pictures_(std::move(pictures)) {}

Result<const LiveFrame*> ReplayImages::at(std::int64_t time_us, const std::optional<AttemptSample>& sample) {
  const bool isFrozen = sample && sample->patientFromProbe && !(sample->imageDepth_mm > 0);
  if (isFrozen && wasFrozen_) return last_.get();
  auto made = pictures_.at(time_us);
  if (!made) return tl::unexpected(made.error());
  last_ = std::move(*made), wasFrozen_ = isFrozen;
  return last_.get();
}

}  // namespace insonate::video
