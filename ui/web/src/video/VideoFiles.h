#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/teaching/NeedlePath.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace insonate::web {

/// Longer attempts get no video, since one would occupy the server for hours.
inline constexpr std::int64_t kLongestVideo_us = std::int64_t{3600} * 1'000'000;

/// Folder of the videos of attempts: ID.webm, and ID.json with the attempt's milestones and errors and the path of the
/// needle. It is a cache: each file can be made again. For any thread and several servers.
class VideoFiles {
 public:
  /// An empty folder: there are no videos.
  explicit VideoFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool isUsed() const { return !folder_.empty(); }
  /// Path of the video of an attempt, whether it is there or not.
  std::filesystem::path video(const std::string& attempt) const;
  bool has(const std::string& attempt) const;

  /// Stores what the page of an attempt shows beside the video. `path`: empty if it is not known.
  Result<void> keepMoments(const std::string& attempt, const std::vector<AttemptMoment>& moments,
                           const std::optional<NeedlePath>& path = {}) const;
  /// Returns the milestones and errors of an attempt; none if they cannot be read.
  std::vector<AttemptMoment> moments(const std::string& attempt) const;

  /// Returns the path of the needle; empty if it was not stored or cannot be read.
  std::optional<NeedlePath> path(const std::string& attempt) const;

  /// Deletes the video of an attempt with its milestones and errors. Fails if a file is still there.
  Result<void> remove(const std::string& attempt) const;
  /// Marks a video as used now.
  void use(const std::string& attempt) const;
  /// Removes the videos that were used longest ago, until all together have this size at most; keeps `newest`.
  void trim(std::uint64_t max_bytes, const std::string& newest) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace insonate::web
