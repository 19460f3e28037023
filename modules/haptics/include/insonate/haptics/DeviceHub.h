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

/// Returns a bus that lists and opens the USB and Bluetooth devices, through hidapi.
std::shared_ptr<haptics::HidBus> usbDevices();

struct HubOptions {
  std::chrono::milliseconds rescan{1000};  ///< interval between two searches for plugged-in devices
  std::vector<DeviceTable> tables = builtInDeviceTables();
};

/// Finds and owns all haptic devices and pedals: USB and Bluetooth devices that match a device table, and devices that
/// the program adds. A matching device is opened when it is plugged in, and again each time it is reconnected. All
/// functions may be called from any thread except that of the servo (the force loop), which uses the devices directly.
class DeviceHub {
 public:
  explicit DeviceHub(std::shared_ptr<haptics::HidBus> bus, HubOptions options = {});
  /// Sends each device a last zero force and releases it. If another object still owns a device, the phase of the
  /// device becomes kAbsent.
  ~DeviceHub();
  DeviceHub(const DeviceHub&) = delete;
  DeviceHub& operator=(const DeviceHub&) = delete;

  /// Starts a thread that searches for plugged-in devices now and after each interval HubOptions::rescan. Returns at
  /// once.
  void start();
  /// Searches for devices once, on the calling thread. Do not call this while start() is in effect.
  void scanOnce();

  /// Adds a device that the search of USB and Bluetooth does not find: a simulated or replayed device, or a device of a
  /// vendor's SDK.
  void add(std::shared_ptr<HapticDevice> device);
  /// Returns all devices that have been found or added, in the order in which they appeared, including devices that are
  /// no longer present.
  std::vector<std::shared_ptr<HapticDevice>> devices() const;
  /// Returns the device events (connected, lost, failed) since the last call, at most 1000, oldest first.
  std::vector<DeviceEvent> takeEvents();
  /// Returns the recorder of the raw input and output reports of all USB and Bluetooth devices.
  ReportRecorder& recorder() { return *recorder_; }

 private:
  struct Slot {
    std::string kind;  ///< identifies a device across reconnections: vendor, product and serial number
    std::shared_ptr<haptics::HidDevice> device;
  };

  const DeviceTable* tableFor(const haptics::HidFound& found) const;
  haptics::HidDevice& slotFor(const haptics::HidFound& found, const DeviceTable& table);

  std::shared_ptr<haptics::HidBus> bus_;
  HubOptions options_;
  std::shared_ptr<haptics::EventQueue> events_;
  std::shared_ptr<ReportRecorder> recorder_;
  mutable std::mutex mutex_;  ///< guards slots_ and others_
  std::vector<Slot> slots_;
  std::vector<std::shared_ptr<HapticDevice>> others_;
  std::mutex waitMutex_;
  std::condition_variable_any wait_;
  std::jthread scanner_;
};

}  // namespace insonate
