#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/LiveImaging.h>

#include <cstdint>
#include <memory>

namespace insonate {

/// Renders the ultrasound images of a recorded attempt from its case. Each image depends only on the recorded state at
/// its time: tissue deformation is solved from the undeformed state, persistence is left out, and electronic noise is
/// seeded by the time. Images are therefore the same bit for bit in any order, on the same engine and kind of
/// processor. The image that the trainee saw live may differ slightly, since live tissue is solved from the frame
/// before. Not for concurrent use; uses the calling thread's TBB arena.
class AttemptPictures {
 public:
  /// Fails with a sentence if `patient` is not the recorded case, or if the recording has no settings. `workAhead`: a
  /// low-priority thread prepares the acoustic scenes of all recorded probe positions, which takes some seconds; after
  /// that, an image of any moment takes some tenths of a second at most. Without `workAhead`, the first image at each
  /// position takes seconds.
  static Result<AttemptPictures> make(std::shared_ptr<const AttemptRecording> recording,
                                      std::shared_ptr<const PatientCase> patient, bool workAhead = false);
  AttemptPictures(AttemptPictures&&) noexcept;
  AttemptPictures& operator=(AttemptPictures&&) noexcept;
  ~AttemptPictures();

  /// Renders the image that was on the screen at this time: that of the last sample until then or, if the image was
  /// frozen, of the sample at which it was frozen. Null before the first sample and while no probe is held. The frame
  /// includes its envelope; LiveFrame::number is 0 and LiveFrame::time_s is that of the sample. Fails if the recording
  /// is damaged at that time, or if its engine is not available.
  Result<std::shared_ptr<const LiveFrame>> at(std::int64_t time_us);

 private:
  struct State;
  explicit AttemptPictures(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
