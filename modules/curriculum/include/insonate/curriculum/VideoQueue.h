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
    Waiting,  ///< requested; other videos are made first
    Making,
    Ended,  ///< the video is complete, or could not be made for the reason VideoState::why
  };
  Stage stage = Stage::NotRequested;
  double fraction = 0;         ///< share of the video that is made, 0 to 1
  std::int64_t taken_us = 0;   ///< time since a server began to make the video, microseconds
  std::int64_t before = 0;     ///< number of other videos that will be made before this video
  std::int64_t length_us = 0;  ///< length of the attempt
  std::string why{};           ///< reason why the video could not be made; else empty
};

/// Requests for videos of attempts, with the permissions of a signed-in user: who may see an attempt may request its
/// video.
class AttemptVideos {
 public:
  explicit AttemptVideos(SignedIn by) : by_(std::move(by)) {}

  /// Requests the video of an attempt. Does nothing if the video is already waiting or being made. A video that is
  /// complete is made again.
  Result<void> request(const std::string& attempt) const;
  /// Returns the state of the video of an attempt. The audit log gets one entry for all calls within an hour, since a
  /// page of the server asks for the state every few seconds.
  Result<VideoState> state(const std::string& attempt) const;

 private:
  SignedIn by_;
};

/// An attempt whose video a server is to make.
struct WaitingVideo {
  std::string attempt{};
  std::filesystem::path recording{};
};

/// Requested videos of attempts, for the servers that make them. Several servers may share a database: takeNext()
/// assigns each video to one of them. If that server does not call reportProgress() for two minutes, for example
/// because it has crashed, the video is assigned again. After three such tries, the video counts as failed, with a
/// reason. May be used on any thread.
class VideoQueue {
 public:
  /// `server`: a name that no other server has.
  VideoQueue(CurriculumStore store, std::string server) : store_(std::move(store)), server_(std::move(server)) {}

  /// Assigns the video that has waited longest to this server, and returns its attempt; empty if no video waits. The
  /// assignment counts as one of the three tries, unless release() gives the video back.
  Result<std::optional<WaitingVideo>> takeNext() const;
  /// Stores the share of a video that this server has made, 0 to 1. Returns false if the video was assigned to another
  /// server meanwhile; this server must then stop.
  Result<bool> reportProgress(const std::string& attempt, double fraction) const;
  /// Stores that a video is complete, or that it could not be made for the reason `why` (empty: complete). Has no
  /// effect if the video was assigned to another server meanwhile.
  Result<void> storeResult(const std::string& attempt, const std::string& why) const;
  /// Gives back a video that this server will not make, for example because the server is stopping. takeNext() can
  /// assign the video again at once.
  Result<void> release(const std::string& attempt) const;
  /// Returns the number of videos that wait or are being made.
  Result<std::int64_t> waiting() const;

 private:
  CurriculumStore store_;
  std::string server_;
};

}  // namespace insonate
