#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/LiveImaging.h>

#include <cstdint>
#include <memory>

namespace insonate {

/// Renders the ultrasound images of a recorded attempt from its case. Each image depends only on the recorded state at
/// its time: the deformation of tissue is solved from the undeformed state, there is no persistence, and the time seeds
/// the electronic noise. With the same engine and kind of processor, an image is therefore the same bit for bit,
/// whichever images are rendered before it. The live image may have differed slightly, since live imaging continues the
/// deformation of the previous frame. One object must not be used concurrently; uses the calling thread's TBB arena.
class AttemptImages {
 public:
  /// Fails with a sentence if `patient` is not the recorded case, or if the recording has no settings. `workAhead`,
  /// true: a low-priority thread makes the acoustic scenes of all recorded probe positions in advance, which takes some
  /// seconds; an image then takes some tenths of a second at most. false: the first image at each position takes
  /// seconds.
  static Result<AttemptImages> make(std::shared_ptr<const AttemptRecording> recording,
                                    std::shared_ptr<const PatientCase> patient, bool workAhead = false);
  AttemptImages(AttemptImages&&) noexcept;
  AttemptImages& operator=(AttemptImages&&) noexcept;
  ~AttemptImages();

  /// Renders the image that was shown at this time: the image of the last sample at or before this time or, if the
  /// image was frozen, of the sample at which it was frozen. Returns null before the first sample and while no probe is
  /// held. The frame includes its envelope; LiveFrame::number is 0, and LiveFrame::time_s is the time of the sample.
  /// Fails if the recording is damaged at that time, or if its engine is not available.
  Result<std::shared_ptr<const LiveFrame>> at(std::int64_t time_us);

 private:
  struct State;
  explicit AttemptImages(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
