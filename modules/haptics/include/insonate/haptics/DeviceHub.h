#pragma once

#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/ReportRecording.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace insonate {

namespace haptics {
class EventQueue;
class HidBus;
class HidDevice;
struct HidFound;
}  // namespace haptics

/// Devices on USB and Bluetooth, through hidapi.
std::shared_ptr<haptics::HidBus> usbDevices();

struct HubOptions {
  std::chrono::milliseconds rescan{1000};  ///< between two looks at what is plugged in
  std::vector<DeviceTable> tables = builtInDeviceTables();
};

/// All devices of this session: those on the bus that a table knows, opened when they are plugged in and again after
/// they were gone, and those that are added by hand. All functions may be called from any thread but the servo's,
/// which works with the devices themselves.
class DeviceHub {
 public:
  explicit DeviceHub(std::shared_ptr<haptics::HidBus> bus, HubOptions options = {});
  /// Releases all devices, after a last zero force. Devices that others still hold stay absent.
  ~DeviceHub();
  DeviceHub(const DeviceHub&) = delete;
  DeviceHub& operator=(const DeviceHub&) = delete;

  /// Looks at the bus now and each `rescan`, on a thread of its own. Returns at once.
  void start();
  /// Searches for devices once, on the calling thread. Not to be called while start() is in effect.
  void scanOnce();

  /// A simulated, replayed or vendor's device.
  void add(std::shared_ptr<HapticDevice> device);
  /// All devices seen since the start, including those that are gone, in the order in which they came.
  std::vector<std::shared_ptr<HapticDevice>> devices() const;
  /// Returns the events since the last call; the oldest first, 1000 at most.
  std::vector<DeviceEvent> takeEvents();
  /// Raw reports of all devices on the bus.
  ReportRecorder& recorder() { return *recorder_; }

 private:
  struct Slot {
    std::string kind;  ///< vendor, product and serial number
    std::shared_ptr<haptics::HidDevice> device;
  };

  const DeviceTable* tableFor(const haptics::HidFound& found) const;
  haptics::HidDevice& slotFor(const haptics::HidFound& found, const DeviceTable& table);

  std::shared_ptr<haptics::HidBus> bus_;
  HubOptions options_;
  std::shared_ptr<haptics::EventQueue> events_;
  std::shared_ptr<ReportRecorder> recorder_;
  mutable std::mutex mutex_;  ///< of slots_ and others_
  std::vector<Slot> slots_;
  std::vector<std::shared_ptr<HapticDevice>> others_;
  std::mutex waitMutex_;
  std::condition_variable_any wait_;
  std::jthread scanner_;
};

}  // namespace insonate
