#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/LiveImaging.h>

#include <cstdint>
#include <memory>

namespace insonate {

/// The ultrasound images of a recorded attempt, made again from its case. An image is a function of what the
/// recording says of its time: the tissue is solved from rest, persistence is left out and electronic noise is that of
/// its time, so that it is the same bit for bit whatever was looked at before, on the same engine and kind of
/// processor; the live one, whose tissue goes on from the image before, was near it. Not for concurrent use; uses the
/// calling thread's TBB arena.
class AttemptPictures {
 public:
  /// Fails with a sentence on another case than the recording's, and on a recording without settings. `workAhead`: a
  /// thread of low priority computes, for some seconds, what the scenes of all places are made of where the probe was;
  /// then an image takes some tenths of a second at most, from anywhere. Without it, the first at each place takes
  /// seconds.
  static Result<AttemptPictures> make(std::shared_ptr<const AttemptRecording> recording,
                                      std::shared_ptr<const PatientCase> patient, bool workAhead = false);
  AttemptPictures(AttemptPictures&&) noexcept;
  AttemptPictures& operator=(AttemptPictures&&) noexcept;
  ~AttemptPictures();

  /// As the screen showed it at this time: of the last sample until then, or of the one at which the image was
  /// frozen. Null before the first sample and while nobody holds the probe. The frame has an envelope; its number is 0
  /// and its time that of the sample. Fails where the recording is damaged there, and where its engine cannot be had.
  Result<std::shared_ptr<const LiveFrame>> at(std::int64_t time_us);

 private:
  struct State;
  explicit AttemptPictures(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
