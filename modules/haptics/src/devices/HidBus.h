#pragma once

#include <insonate/core/Result.h>
#include <insonate/haptics/DeviceLimits.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::haptics {

/// A plugged-in HID interface (USB or Bluetooth).
struct HidFound {
  std::string path;  ///< system path for opening the interface; it changes each time the device is plugged in
  std::string maker, name, serial;
  std::uint16_t vendor = 0, product = 0, usagePage = 0, usage = 0;
  std::optional<DeviceLimits> limits = {};  ///< limits of the device, if the bus knows them better than the device
                                            ///< table; empty: those of the table apply
};

/// An open HID interface. One object must be used on one thread only.
class HidHandle {
 public:
  virtual ~HidHandle() = default;
  /// Waits up to `wait_ms` for the next report. Returns its length, 0 if none arrived, or -1 if the device is
  /// disconnected.
  virtual int read(std::span<std::uint8_t> report, int wait_ms) noexcept = 0;
  /// Sends an output report, whose first byte is its id. Returns false if it could not be sent.
  virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
};

/// Lists and opens plugged-in HID devices. One object must be used on one thread only.
class HidBus {
 public:
  virtual ~HidBus() = default;
  /// Lists the plugged-in interfaces, one entry for each top-level HID usage of each.
  virtual std::vector<HidFound> list() = 0;
  /// Opens an interface. Fails with a sentence that says what to do if access rights are missing.
  virtual Result<std::unique_ptr<HidHandle>> open(const HidFound& found) = 0;
};

}  // namespace insonate::haptics
