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

/// A HID interface that is plugged in now.
struct HidFound {
  std::string path;  ///< path for opening the interface; it changes each time the device is plugged in
  std::string maker, name, serial;
  std::uint16_t vendor = 0, product = 0, usagePage = 0, usage = 0;
  std::optional<DeviceLimits> limits = {};  ///< set if the bus knows the limits better than the table
};

/// An open interface. One thread reads and writes it.
class HidHandle {
 public:
  virtual ~HidHandle() = default;
  /// Waits up to `wait_ms` for the next report. Returns its length, 0 if none arrived, or -1 if the device is gone.
  virtual int read(std::span<std::uint8_t> report, int wait_ms) noexcept = 0;
  /// Sends a report, which begins with its id. Returns false if it could not be sent.
  virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
};

/// Devices that are plugged in. One thread lists and opens devices.
class HidBus {
 public:
  virtual ~HidBus() = default;
  /// Lists one entry for each top-level usage of each interface.
  virtual std::vector<HidFound> list() = 0;
  /// Opens an interface. Fails with a sentence that says what to do if access rights are missing.
  virtual Result<std::unique_ptr<HidHandle>> open(const HidFound& found) = 0;
};

}  // namespace insonate::haptics
