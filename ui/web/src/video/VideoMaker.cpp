#include "video/VideoMaker.h"

#include "background/Pause.h"
#include "monitoring/FailureLog.h"
#include "video/VideoFiles.h"

#include <insonate/core/ThreadPriority.h>
#include <insonate/simulator/AttemptCase.h>
#include <insonate/teaching/NeedlePath.h>
#include <insonate/video/AttemptVideo.h>

#include <QUuid>
#include <chrono>
#include <memory>
#include <utility>

namespace insonate::web {
namespace {

using namespace std::chrono_literals;

/// Replaces a path of the server, which is not for users.
void hide(std::string& sentence, const std::string& path, const std::string& words) {
  if (path.empty()) return;
  // The words may contain the path, so that the search continues behind them.
  for (std::size_t at = sentence.find(path); at != std::string::npos; at = sentence.find(path, at + words.size()))
    sentence.replace(at, path.size(), words);
}

}  // namespace

VideoMaker::VideoMaker(const CurriculumStore& store, const WebOptions& options)
    : options_(options),
      queue_(store, QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString()),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void VideoMaker::run(const std::stop_token& stop) {
  lowerThreadPriority();
  for (;;) {
    const auto made = makeNext(stop);
    if (!made) logFailure(options_.log, "video queue failed", made.error().message);
    // A database that fails is tried again; what waits is kept there.
    if (!pauseUnlessStopped(stop, !made ? 30s : *made ? 0s : 1s)) return;
  }
}

Result<bool> VideoMaker::makeNext(const std::stop_token& stop) {
  const auto waiting = queue_.takeNext();
  if (!waiting) return tl::unexpected(waiting.error());
  if (!*waiting) return false;
  const WaitingVideo& video = **waiting;
  std::string why;
  try {
    if (auto made = make(video, stop); !made) why = made.error().message;
  } catch (const std::exception& error) {
    why = std::string("The video cannot be made: ") + error.what() + ".";
  }
  removeIfErased(video);
  if (stop.stop_requested() && !why.empty()) {
    const auto released = queue_.release(video.attempt);
    return released ? Result<bool>(true) : tl::unexpected(released.error());
  }
  // Another server has it, which concludes it, or the person was erased.
  if (why == kCancelled) return true;
  if (!why.empty()) logFailure(options_.log, "video failed", why);
  hide(why, video.recording.string(), "The recording");
  hide(why, options_.videos.string(), "The folder of videos");
  hide(why, options_.cases.string(), "The folder of cases");
  const auto concluded = queue_.storeResult(video.attempt, why);
  return concluded ? Result<bool>(true) : tl::unexpected(concluded.error());
}

Result<void> VideoMaker::make(const WaitingVideo& video, const std::stop_token& stop) {
  auto last = std::chrono::steady_clock::now() - 1h;
  const Progress progress = [&](std::string_view, double fraction) {
    if (stop.stop_requested()) return false;
    const auto now = std::chrono::steady_clock::now();
    if (now - last < 3s) return true;
    last = now;
    const auto kept = queue_.reportProgress(video.attempt, fraction);
    // A database that does not answer for a while does not end the work.
    return !kept || *kept;
  };
  auto opened = AttemptRecording::open(video.recording);
  if (!opened) return tl::unexpected(opened.error());
  if (opened->end_us() > kLongestVideo_us) return fail("The recording is longer than an hour.");
  const auto recording = std::make_shared<const AttemptRecording>(std::move(*opened));
  const Progress preparing = [&](std::string_view doing, double) { return progress(doing, 0); };
  auto found = caseOfAttempt(recording->header(), {options_.cases}, preparing);
  if (!found) return tl::unexpected(found.error());
  const auto moments = momentsOf(*recording);
  if (!moments) return tl::unexpected(moments.error());
  const auto path = needlePathOf(*recording, *found);
  if (!path) return tl::unexpected(path.error());
  const VideoFiles files(options_.videos);
  if (auto kept = files.keepMoments(video.attempt, *moments, *path); !kept) return kept;
  // One thread: the workers of others would have the priority of pages.
  auto written = writeAttemptVideo(recording, std::make_shared<const PatientCase>(std::move(*found)),
                                   files.video(video.attempt), {.threads = 1}, progress);
  if (!written) return written;
  files.trim(static_cast<std::uint64_t>(options_.videoSpace_GB * 1e9), video.attempt);
  return {};
}

void VideoMaker::removeIfErased(const WaitingVideo& video) const {
  std::error_code error;
  // A folder that cannot be read for a while is no erasure.
  if (std::filesystem::exists(video.recording, error) || error) return;
  if (auto removed = VideoFiles(options_.videos).remove(video.attempt); !removed)
    logFailure(options_.log, "video removal failed", removed.error().message);
}

}  // namespace insonate::web
