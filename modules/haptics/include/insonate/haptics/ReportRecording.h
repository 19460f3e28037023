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

/// Records raw input and output reports of devices in a file, for bug reports and replays. The file is text with one
/// line per report: seconds, device id, name of the device table, `in` or `out`, bytes in hex. A thread of the recorder
/// writes to the disk, so that record() never waits for the disk and may be called on the force loop's thread.
class ReportRecorder {
 public:
  ReportRecorder() = default;
  ~ReportRecorder();
  ReportRecorder(const ReportRecorder&) = delete;
  ReportRecorder& operator=(const ReportRecorder&) = delete;

  /// Starts recording into `file`, which is overwritten; fails if it cannot be written. Recording continues until
  /// stop(), which must be called on the same thread.
  Result<void> start(const std::filesystem::path& file);
  /// Stops recording. Fails if some reports could not be written.
  Result<void> stop();
  bool isRunning() const noexcept { return running_.load(std::memory_order_acquire); }
  /// Records one report. `in`, true: the device sent the report; false: the program sent it to the device. May be
  /// called from any thread.
  void record(const std::string& device, std::string_view table, bool in, std::span<const std::uint8_t> report);

 private:
  void flush();

  std::atomic<bool> running_{false};
  std::mutex mutex_;
  std::string pending_;  ///< lines of the file that are not yet written
  bool lost_ = false;    ///< true: lines were dropped, since too many waited to be written
  std::int64_t begin_ns_ = 0;
  // The following members are used by the recorder's thread while it runs.
  std::filesystem::path path_;
  std::ofstream file_;
  std::jthread writer_;
};

/// One input or output report of a device, as read from a recording by readRecording().
struct RecordedReport {
  double time_s = 0;  ///< time since the recording began
  std::string device, table;
  bool in = true;
  std::vector<std::uint8_t> bytes;
};

/// Reads a file that ReportRecorder wrote. Fails with a sentence that names the line that cannot be read.
Result<std::vector<RecordedReport>> readRecording(const std::filesystem::path& file);

/// Makes a device that replays recorded reports: the reports arrive at their recorded times and are decoded like the
/// reports of the real device. Forces have no effect. The replay starts at once; if `again` is true, the replay
/// repeats. `device` is the id of the recorded device; empty: the device of the first report. Fails if the recording
/// has no report of a device with a built-in table.
Result<std::shared_ptr<HapticDevice>> replayRecording(const std::vector<RecordedReport>& reports,
                                                      const std::string& device = {}, bool again = false);

}  // namespace insonate
