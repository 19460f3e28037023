#include "HidDevice.h"

#include <insonate/haptics/ReportRecording.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace insonate {
namespace {

using haptics::EventQueue;
using haptics::HidDevice;
using haptics::HidHandle;

/// An interface that delivers recorded reports at their recorded times.
class RecordedHandle final : public HidHandle {
 public:
  RecordedHandle(std::vector<RecordedReport> reports, bool again) : reports_(std::move(reports)), again_(again) {}

  int read(std::span<std::uint8_t> report, int wait_ms) noexcept override {
    using namespace std::chrono;
    if (next_ == reports_.size() && again_) {
      next_ = 0;
      begin_ = steady_clock::now();
    }
    const auto limit = steady_clock::now() + milliseconds(wait_ms);
    const auto due = next_ < reports_.size() ? begin_ + duration_cast<steady_clock::duration>(duration<double>(
                                                            reports_[next_].time_s - reports_.front().time_s))
                                             : steady_clock::time_point::max();
    if (due > limit) {
      if (wait_ms > 0) std::this_thread::sleep_until(limit);
      return 0;
    }
    std::this_thread::sleep_until(due);
    const auto& bytes = reports_[next_++].bytes;
    const std::size_t size = std::min(bytes.size(), report.size());
    std::copy_n(bytes.begin(), size, report.begin());
    return static_cast<int>(size);
  }
  bool write(std::span<const std::uint8_t>) noexcept override { return true; }

 private:
  const std::vector<RecordedReport> reports_;
  const bool again_;
  std::size_t next_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

const DeviceTable* tableNamed(const std::string& name) {
  for (const DeviceTable& table : builtInDeviceTables()) {
    std::string asWord = table.name;
    std::replace(asWord.begin(), asWord.end(), ' ', '_');
    if (asWord == name) return &table;
  }
  return nullptr;
}

}  // namespace

Result<std::shared_ptr<HapticDevice>> replayRecording(const std::vector<RecordedReport>& reports,
                                                      const std::string& device, bool again) {
  std::vector<RecordedReport> own;
  for (const RecordedReport& report : reports) {
    const std::string& wanted = !device.empty() ? device : own.empty() ? report.device : own[0].device;
    if (report.in && !report.bytes.empty() && report.device == wanted) own.push_back(report);
  }
  if (own.empty())
    return fail(device.empty() ? "The recording holds no report of a device."
                               : "The recording holds no report of the device '" + device + "'.");
  const DeviceTable* table = tableNamed(own[0].table);
  if (!table) return fail("The recorded device '" + own[0].table + "' is not in any device table.");
  DeviceInfo info{"recording:" + own[0].device, table->name + " (recorded)", table->kind, table->limits};
  auto replay = std::make_shared<HidDevice>(std::move(info), std::make_shared<const DeviceTable>(*table),
                                            std::make_shared<EventQueue>(), nullptr);
  replay->attach(std::make_unique<RecordedHandle>(std::move(own), again));
  return replay;
}

}  // namespace insonate
