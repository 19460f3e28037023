#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/LiveImaging.h>

#include <cstdint>
#include <memory>

namespace insonate {

/// Renders the ultrasound images of a recorded attempt from its case. An image depends on the recorded state of its
/// time alone: the tissue is solved from rest, persistence is left out and electronic noise is that of its time, so
/// that it is the same bit for bit in any order, on the same engine and kind of processor. The image that the trainee
/// saw live may differ slightly, since live tissue is solved from the frame before. Not for concurrent use; uses the
/// calling thread's TBB arena.
class AttemptPictures {
 public:
  /// Fails with a sentence if the case is not the recording's, or if the recording has no settings. `workAhead`: a
  /// low-priority thread prepares the scenes of all probe positions of the recording, which takes some seconds; after
  /// that, an image of any moment takes some tenths of a second at most. Without `workAhead`, the first image at each
  /// position takes seconds.
  static Result<AttemptPictures> make(std::shared_ptr<const AttemptRecording> recording,
                                      std::shared_ptr<const PatientCase> patient, bool workAhead = false);
  AttemptPictures(AttemptPictures&&) noexcept;
  AttemptPictures& operator=(AttemptPictures&&) noexcept;
  ~AttemptPictures();

  /// Renders the image that was on the screen at this time: the image of the last sample until then or, if the image
  /// was frozen, of the sample at which it was frozen. Null before the first sample and while nobody holds the probe.
  /// The frame has an envelope; its number is 0 and its time is that of the sample. Fails if the recording is damaged
  /// there, or if its engine is not available.
  Result<std::shared_ptr<const LiveFrame>> at(std::int64_t time_us);

 private:
  struct State;
  explicit AttemptPictures(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
