#include "attempt/Canvas.h"
#include "attempt/ReplayCursor.h"
#include "attempt/ReplayImages.h"
#include "attempt/VideoDrawing.h"

#include <insonate/video/AttemptVideo.h>
#include <insonate/video/VideoWriter.h>

#include <tbb/task_arena.h>

#include <limits>
#include <utility>

namespace insonate {
namespace {

Result<void> filmAttempt(const std::shared_ptr<const AttemptRecording>& recording,
                         const std::shared_ptr<const PatientCase>& patient, const std::filesystem::path& target,
                         const AttemptVideoOptions& options, const Progress& progress) {
  if (recording->segmentCount() == 0) return fail("The recording has no samples, so that there is no video of it.");
  const auto moments = momentsOf(*recording);
  if (!moments) return tl::unexpected(moments.error());
  auto procedure = builtInProcedure(recording->header().procedure);
  if (!procedure) return tl::unexpected(procedure.error());
  auto pictures = AttemptImages::make(recording, patient, true);
  if (!pictures) return tl::unexpected(pictures.error());
  video::ReplayImages images(std::move(*pictures));
  video::ReplayCursor replay(recording, std::move(*procedure));
  video::Canvas canvas(kAttemptVideoWidth_px, kAttemptVideoHeight_px);
  const std::int64_t end_us = recording->end_us(), rate = options.framesPerSecond;
  const auto draw = [&](std::int64_t index, VideoFrame& frame) -> Result<void> {
    const std::int64_t time_us = index * 1'000'000 / rate;
    if (auto played = replay.advance(time_us); !played) return played;
    const auto image = images.at(time_us, replay.sample());
    if (!image) return tl::unexpected(image.error());
    video::drawMoment({.time_us = time_us, .end_us = end_us, .image = *image, .replay = replay, .moments = *moments},
                      canvas);
    canvas.copyTo(frame);
    return {};
  };
  return writeVideo(target, {.framesPerSecond = options.framesPerSecond}, end_us * rate / 1'000'000 + 1, draw,
                    progress);
}

}  // namespace

Result<void> writeAttemptVideo(std::shared_ptr<const AttemptRecording> recording,
                               std::shared_ptr<const PatientCase> patient, const std::filesystem::path& target,
                               const AttemptVideoOptions& options, const Progress& progress) {
  tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
  return arena.execute([&] { return filmAttempt(recording, patient, target, options, progress); });
}

Result<std::vector<AttemptMoment>> momentsOf(const AttemptRecording& recording) {
  auto procedure = builtInProcedure(recording.header().procedure);
  if (!procedure) return tl::unexpected(procedure.error());
  ProcedureRun run(std::move(*procedure), recording.header().picture, recording.header().vessels);
  const auto played = recording.play(
      std::numeric_limits<std::int64_t>::max(),
      [&](const RecordingSegment::Entry& entry) { std::visit([&](const auto& what) { run.add(what); }, entry); });
  if (!played) return tl::unexpected(played.error());
  return computeScore(run, recording.status()).moments;
}

}  // namespace insonate
