#pragma once

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/VideoQueue.h>
#include <insonate/web/WebServer.h>

#include <stop_token>
#include <string>
#include <thread>

namespace insonate::web {

/// Makes the requested videos of attempts, one after another, on a thread of its own with low priority, until it is
/// destroyed; it then stops within a second and gives a video in progress back to the queue. Several servers with one
/// database share the work.
class VideoMaker {
 public:
  VideoMaker(const CurriculumStore& store, const WebOptions& options);
  VideoMaker(const VideoMaker&) = delete;
  VideoMaker& operator=(const VideoMaker&) = delete;

 private:
  void run(const std::stop_token& stop);
  /// Makes the next video; returns false if none waits.
  Result<bool> makeNext(const std::stop_token& stop);
  /// Makes a video, and returns the reason if it cannot be made.
  Result<void> make(const WaitingVideo& video, const std::stop_token& stop);
  /// Deletes what was made of a video if the recording is gone, since the person was erased meanwhile.
  void removeIfErased(const WaitingVideo& video) const;

  const WebOptions options_;
  const VideoQueue queue_;
  std::jthread thread_;  // declared last, since the thread uses the other members
};

}  // namespace insonate::web
