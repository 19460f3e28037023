#pragma once

#include <insonate/core/Result.h>
#include <insonate/haptics/HapticDevice.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace insonate {

/// Writes raw reports as they come and go, for a bug report or a replay. Text, one report a line: seconds, the
/// device's id, its table, `in` or `out`, bytes in hex. A thread of the recorder writes the disk: put() may be called
/// where forces depend on it, even if the disk stalls.
class ReportRecorder {
 public:
  ReportRecorder() = default;
  ~ReportRecorder();
  ReportRecorder(const ReportRecorder&) = delete;
  ReportRecorder& operator=(const ReportRecorder&) = delete;

  /// Starts a file, over an older one; fails where it cannot be written. Runs until stop(). One thread starts and
  /// stops.
  Result<void> start(const std::filesystem::path& file);
  /// Fails where the disk did not take all of it.
  Result<void> stop();
  bool isRunning() const noexcept { return running_.load(std::memory_order_acquire); }
  /// Any thread.
  void put(const std::string& device, std::string_view table, bool in, std::span<const std::uint8_t> report);

 private:
  void flush();

  std::atomic<bool> running_{false};
  std::mutex mutex_;
  std::string pending_;  ///< lines that wait for the disk
  bool lost_ = false;    ///< so many that some were left out
  std::int64_t begin_ns_ = 0;
  // The recorder's thread, while it runs.
  std::filesystem::path path_;
  std::ofstream file_;
  std::jthread writer_;
};

/// One report of a recording.
struct RecordedReport {
  double time_s = 0;  ///< since the recording began
  std::string device, table;
  bool in = true;
  std::vector<std::uint8_t> bytes;
};

/// Fails with the line that cannot be read.
Result<std::vector<RecordedReport>> readRecording(const std::filesystem::path& file);

/// Replays a recording as a device: its reports come at their recorded pace, through the same decoder. Forces are
/// accepted without effect. Starts at once; with `again`, repeats from the beginning. Fails if the recording has no
/// report of a device that a table knows; `device` empty: the first one's.
Result<std::shared_ptr<HapticDevice>> replayRecording(const std::vector<RecordedReport>& reports,
                                                      const std::string& device = {}, bool again = false);

}  // namespace insonate
