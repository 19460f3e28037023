#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/NeedleWords.h>
#include <insonate/procedure/ProcedureRun.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::video {

/// Plays a recording forward and keeps the state of the attempt at the present time.
class ReplayCursor {
 public:
  ReplayCursor(std::shared_ptr<const AttemptRecording> recording, Procedure procedure);

  /// Plays everything up to this time, which must not decrease. Fails if a part of the recording is damaged.
  Result<void> advance(std::int64_t time_us);

  const ProcedureRun& run() const { return run_; }
  /// The last sample; empty before the first.
  const std::optional<AttemptSample>& sample() const { return sample_; }
  /// Content of the syringe, which stays until the needle is replaced.
  SyringeContent syringe() const { return syringe_; }

 private:
  void take(const AttemptSample& sample);
  void take(const AttemptEvent& event);

  std::shared_ptr<const AttemptRecording> recording_;
  ProcedureRun run_;
  std::size_t stretch_ = 0;                         ///< index of the next stretch to be read
  std::vector<RecordingSegment::Entry> entries_{};  ///< of the stretch in progress
  std::size_t next_ = 0;                            ///< index of the next entry of `entries_`
  std::optional<AttemptSample> sample_{};
  Label tipIn_ = kBackground;
  SyringeContent syringe_ = SyringeContent::Nothing;
};

}  // namespace insonate::video
