#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/AttemptScore.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace insonate {

struct AttemptVideoOptions {
  int framesPerSecond = 15;  ///< 1..60
  int threads = 0;           ///< threads that render images; 0: one for each processor
};

/// Width and height of the video of an attempt: the ultrasound image, and below it the state of the needle, the syringe
/// and the metrics.
inline constexpr int kAttemptVideoWidth_px = 720, kAttemptVideoHeight_px = 720;

/// Writes the video of an attempt (VP9 in WebM) from its recording and its case. Each frame shows the ultrasound image
/// of its time (AttemptImages) with depth scale and orientation mark, the step, place of the needle, content of the
/// syringe, force of the probe, metrics so far, and for some seconds each milestone and error. Needs no display. The
/// file is written atomically. A frame takes some tenths of a second of processor time. Fails if the recording is
/// damaged or empty, if `patient` is another case, when cancelled, or if the file cannot be written.
Result<void> writeAttemptVideo(std::shared_ptr<const AttemptRecording> recording,
                               std::shared_ptr<const PatientCase> patient, const std::filesystem::path& target,
                               const AttemptVideoOptions& options = {}, const Progress& progress = {});

/// Returns milestones and errors of a recorded attempt, in the order of their times. Fails if the recording is damaged
/// or its procedure is not known.
Result<std::vector<AttemptMoment>> momentsOf(const AttemptRecording& recording);

}  // namespace insonate
