#pragma once

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/VideoQueue.h>
#include <insonate/web/WebServer.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace insonate::web {

/// Makes the requested videos of attempts, one after another, on a thread of its own with low priority, until it is
/// destroyed. Several servers with one database share the work.
class VideoMaker {
 public:
  VideoMaker(const CurriculumStore& store, const WebOptions& options);
  /// Stops within a second; a video in progress is given back.
  ~VideoMaker();
  VideoMaker(const VideoMaker&) = delete;
  VideoMaker& operator=(const VideoMaker&) = delete;

 private:
  void run();
  /// Makes the next video; returns false if none waits.
  Result<bool> makeNext();
  /// Makes a video, and returns the reason if it cannot be made.
  Result<void> make(const WaitingVideo& video);
  /// Deletes what was made of a video if the recording is gone, since the person was erased meanwhile.
  void removeIfErased(const WaitingVideo& video) const;

  const WebOptions options_;
  const VideoQueue queue_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::atomic<bool> isEnding_ = false;
  std::thread thread_;
};

}  // namespace insonate::web
