#pragma once

#include "EventQueue.h"
#include "HidBus.h"
#include "StateMaker.h"

#include <insonate/core/Mailbox.h>
#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/ReportDecoder.h>
#include <insonate/haptics/ReportRecording.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace insonate::haptics {

/// A haptic device or pedal on USB or Bluetooth, described by its device table. The object remains when the device is
/// unplugged. Its own thread reads reports, computes states and writes forces. The thread that searches for devices
/// calls attach() with an open interface each time the device is plugged in.
class HidDevice final : public HapticDevice {
 public:
  HidDevice(DeviceInfo info, std::shared_ptr<const DeviceTable> table, std::shared_ptr<EventQueue> events,
            std::shared_ptr<ReportRecorder> recorder);
  ~HidDevice() override;

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_.load(std::memory_order_acquire); }
  std::string error() const override;
  DeviceCounters counters() const noexcept override;
  bool pollState(DeviceState& state) noexcept override;
  void push(const Force& force) noexcept override;
  void calibrate() override { calibrate_.store(true, std::memory_order_relaxed); }

  /// Tells whether an open interface is attached; for the thread that searches for devices.
  bool attached() const noexcept { return attached_.load(std::memory_order_acquire); }
  const std::string& path() const { return path_; }
  void opening(const std::string& path);
  void attach(std::unique_ptr<HidHandle> handle);
  void cannotOpen(const std::string& why);
  /// Sets the device's phase to kAbsent, since a search has not found the device.
  void missing();
  /// Reports to the user if writing a force to the device has been blocked for 100 ms.
  void watch(std::int64_t now_ns);
  /// Sends a last zero force and releases the device.
  void close();

 private:
  struct Pushed {
    Force force;
    std::int64_t time_ns = 0;
  };

  void serve();
  bool readAll(std::int64_t& now_ns);
  void receive(std::span<const std::uint8_t> report, std::int64_t now_ns);
  void postState(std::int64_t now_ns) noexcept;
  bool sendForce(std::int64_t now_ns);
  bool write(const Force& force);
  void checkSilence(std::int64_t now_ns);
  void reportRefused(std::int64_t now_ns);
  void enter(DevicePhase phase, std::string text, bool error);

  const DeviceInfo info_;
  const std::shared_ptr<const DeviceTable> table_;
  const std::shared_ptr<EventQueue> events_;
  const std::shared_ptr<ReportRecorder> recorder_;

  std::atomic<DevicePhase> phase_{DevicePhase::kAbsent};
  std::atomic<bool> attached_{false}, stop_{false}, calibrate_{false};
  std::atomic<std::int64_t> writing_ns_{0};  ///< time at which the write in progress began; 0: no write is in progress
  std::atomic<std::uint64_t> reports_{0}, forces_{0}, refused_{0}, lateForces_{0};
  Mailbox<DeviceState> states_;
  Mailbox<Pushed> pushed_;
  mutable std::mutex textMutex_;
  std::string error_;

  std::string path_;
  std::thread thread_;
  // The following members are used by the device's thread only.
  std::unique_ptr<HidHandle> handle_;
  ReportDecoder decoder_;
  StateMaker maker_;
  std::optional<Pushed> latest_;
  std::int64_t reported_ns_ = 0, sent_ns_ = 0, told_ns_ = 0;
  std::uint64_t toldRefused_ = 0;
  std::uint32_t sequence_ = 0;
};

}  // namespace insonate::haptics
