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

/// Records raw input and output reports, for bug reports and replays. The file is text with one line per report:
/// seconds, the device's id, its table, `in` or `out`, bytes in hex. The recorder's own thread writes to the disk, so
/// that put() may be called on a thread that computes forces, even if the disk stalls.
class ReportRecorder {
 public:
  ReportRecorder() = default;
  ~ReportRecorder();
  ReportRecorder(const ReportRecorder&) = delete;
  ReportRecorder& operator=(const ReportRecorder&) = delete;

  /// Starts a file and overwrites an older one; fails if the file cannot be written. Recording continues until stop().
  /// Start and stop it on the same thread.
  Result<void> start(const std::filesystem::path& file);
  /// Stops recording. Fails if some reports could not be written.
  Result<void> stop();
  bool isRunning() const noexcept { return running_.load(std::memory_order_acquire); }
  /// Adds a report. Any thread may call.
  void put(const std::string& device, std::string_view table, bool in, std::span<const std::uint8_t> report);

 private:
  void flush();

  std::atomic<bool> running_{false};
  std::mutex mutex_;
  std::string pending_;  ///< lines that are not yet written
  bool lost_ = false;    ///< so many lines were waiting that some were left out
  std::int64_t begin_ns_ = 0;
  // Used by the recorder's thread while it runs.
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

/// Reads a recording. Fails with the line that cannot be read.
Result<std::vector<RecordedReport>> readRecording(const std::filesystem::path& file);

/// Replays a recording as a device: its reports arrive at their recorded times, through the same decoder. Forces are
/// accepted without effect. The replay starts at once; with `again`, it repeats. `device` selects the device by id;
/// empty: the device of the first report. Fails if the recording has no report of a device that matches a table.
Result<std::shared_ptr<HapticDevice>> replayRecording(const std::vector<RecordedReport>& reports,
                                                      const std::string& device = {}, bool again = false);

}  // namespace insonate
