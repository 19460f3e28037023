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
  std::string path;  ///< where it is opened; another one each time it is plugged in
  std::string maker, name, serial;
  std::uint16_t vendor = 0, product = 0, usagePage = 0, usage = 0;
  std::optional<DeviceLimits> limits = {};  ///< where the bus knows better than the table
};

/// An open interface. One thread reads and writes.
class HidHandle {
 public:
  virtual ~HidHandle() = default;
  /// The next report, or none within `wait_ms`: its bytes, 0, or -1 when the device is gone.
  virtual int read(std::span<std::uint8_t> report, int wait_ms) noexcept = 0;
  /// A report with its id in front; false when it could not be sent.
  virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
};

/// Devices that are plugged in. One thread lists and opens them.
class HidBus {
 public:
  virtual ~HidBus() = default;
  /// One entry for each top-level usage of each interface.
  virtual std::vector<HidFound> list() = 0;
  /// Fails with a sentence that says what to do about missing rights.
  virtual Result<std::unique_ptr<HidHandle>> open(const HidFound& found) = 0;
};

}  // namespace insonate::haptics
