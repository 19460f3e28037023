#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace insonate {

/// State of the video of an attempt.
struct VideoState {
  enum class Stage {
    NotRequested,
    Waiting,  ///< other videos are made before
    Making,
    Ended,  ///< made, or failed for the reason `why`
  };
  Stage stage = Stage::NotRequested;
  double fraction = 0;         ///< share that is done, 0 to 1
  std::int64_t taken_us = 0;   ///< time since a server began with it
  std::int64_t before = 0;     ///< number of other videos that are made or wait before it
  std::int64_t length_us = 0;  ///< length of the attempt
  std::string why{};           ///< reason why the video could not be made; else empty
};

/// Requests for videos of attempts, with the permissions of a signed-in user: who may see an attempt may request its
/// video.
class AttemptVideos {
 public:
  explicit AttemptVideos(SignedIn by) : by_(std::move(by)) {}

  /// Requests the video of an attempt. Does nothing if it waits or is being made; a video that has ended is made again.
  Result<void> request(const std::string& attempt) const;
  /// Returns the state of the video of an attempt. A page asks for the state every few seconds, and a player for the
  /// parts of the video, so that the audit log gets one entry for all calls within an hour.
  Result<VideoState> state(const std::string& attempt) const;

 private:
  SignedIn by_;
};

/// A video that a server makes.
struct WaitingVideo {
  std::string attempt{};
  std::filesystem::path recording{};
};

/// Requested videos of attempts, for the servers that make them. Several servers may share a database: each video is
/// taken by one of them, and taken again if that server has not reported for two minutes. A video with which three
/// servers have ended, or one server three times, ends with a reason. For any thread.
class VideoQueue {
 public:
  /// `server`: a name that no other server has.
  VideoQueue(CurriculumStore store, std::string server) : store_(std::move(store)), server_(std::move(server)) {}

  /// Takes the video that has waited longest; empty if none waits. Counts as a try until the video ends or is given
  /// back.
  Result<std::optional<WaitingVideo>> takeNext() const;
  /// Reports how much of a video is done, 0 to 1. Returns false if another server has taken it meanwhile.
  Result<bool> reportProgress(const std::string& attempt, double fraction) const;
  /// Ends a video, unless another server has taken it. `why`: reason if it could not be made; else empty.
  Result<void> storeResult(const std::string& attempt, const std::string& why) const;
  /// Gives a video back, so that it is taken again at once.
  Result<void> release(const std::string& attempt) const;
  /// Returns the number of videos that wait or are being made.
  Result<std::int64_t> waiting() const;

 private:
  CurriculumStore store_;
  std::string server_;
};

}  // namespace insonate
