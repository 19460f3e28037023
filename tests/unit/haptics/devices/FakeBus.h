#pragma once

#include "Reports.h"
#include "devices/HidBus.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace insonate::test {

/// Input and output of a plugged-in device. Shared by the test and the code that has opened it.
class FakeCable {
 public:
  void say(Bytes report) {
    const std::lock_guard lock(mutex_);
    reports_.push_back(std::move(report));
    news_.notify_all();
  }
  void pull() {
    const std::lock_guard lock(mutex_);
    pulled_ = true;
    news_.notify_all();
  }
  std::vector<Bytes> heard() {
    const std::lock_guard lock(mutex_);
    return heard_;
  }
  /// Each write takes so long.
  void slow(std::chrono::milliseconds by) { slow_ = by.count(); }

  int read(std::span<std::uint8_t> report, int wait_ms) {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, std::chrono::milliseconds(wait_ms), [&] { return pulled_ || !reports_.empty(); });
    if (pulled_) return -1;
    if (reports_.empty()) return 0;
    const Bytes next = std::move(reports_.front());
    reports_.pop_front();
    std::copy_n(next.begin(), std::min(next.size(), report.size()), report.begin());
    return static_cast<int>(std::min(next.size(), report.size()));
  }
  bool write(std::span<const std::uint8_t> report) {
    std::this_thread::sleep_for(std::chrono::milliseconds(slow_.load()));
    const std::lock_guard lock(mutex_);
    if (!pulled_) heard_.emplace_back(report.begin(), report.end());
    return !pulled_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  std::deque<Bytes> reports_;
  std::vector<Bytes> heard_;
  bool pulled_ = false;
  std::atomic<long> slow_{0};
};

/// A bus on which the test plugs devices in and out.
struct FakePorts {
  std::mutex mutex;
  std::map<std::string, std::pair<haptics::HidFound, std::shared_ptr<FakeCable>>> plugged;
  std::string locked;  ///< not empty: nothing may be opened, and this is why

  std::shared_ptr<FakeCable> plug(haptics::HidFound found) {
    const std::lock_guard lock(mutex);
    auto cable = std::make_shared<FakeCable>();
    const std::string path = found.path;
    plugged[path] = {std::move(found), cable};
    return cable;
  }
  void unplug(const std::string& path) {
    const std::lock_guard lock(mutex);
    plugged.at(path).second->pull();
    plugged.erase(path);
  }
};

class FakeBus final : public haptics::HidBus {
 public:
  explicit FakeBus(std::shared_ptr<FakePorts> ports) : ports_(std::move(ports)) {}
  std::vector<haptics::HidFound> list() override {
    const std::lock_guard lock(ports_->mutex);
    std::vector<haptics::HidFound> all;
    for (const auto& [path, device] : ports_->plugged) all.push_back(device.first);
    return all;
  }
  Result<std::unique_ptr<haptics::HidHandle>> open(const haptics::HidFound& found) override {
    const std::lock_guard lock(ports_->mutex);
    if (!ports_->locked.empty()) return fail(ports_->locked);
    return std::make_unique<Handle>(ports_->plugged.at(found.path).second);
  }

 private:
  class Handle final : public haptics::HidHandle {
   public:
    explicit Handle(std::shared_ptr<FakeCable> cable) : cable_(std::move(cable)) {}
    int read(std::span<std::uint8_t> report, int wait_ms) noexcept override { return cable_->read(report, wait_ms); }
    bool write(std::span<const std::uint8_t> report) noexcept override { return cable_->write(report); }

   private:
    std::shared_ptr<FakeCable> cable_;
  };
  std::shared_ptr<FakePorts> ports_;
};

}  // namespace insonate::test
