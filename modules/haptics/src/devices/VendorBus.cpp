#include "HidBus.h"
#include "Rotation.h"

#include <insonate/haptics/DeviceHub.h>
#include <insonate/haptics/ReportDecoder.h>
#include <insonate/haptics/VendorKit.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>

namespace insonate {
namespace {

using haptics::HidBus;
using haptics::HidFound;
using haptics::HidHandle;

/// The ids and reports of a home-built device (resources/haptics/README.md): a device of a vendor's library is
/// presented as one, so that it uses the same code as all others.
constexpr std::uint16_t kVendor = 0x1209, kProduct = 0x0001, kPage = 0xff49, kUsage = 1;
constexpr std::size_t kInBytes = 31, kOutBytes = 15;

void put(std::span<std::uint8_t> bytes, std::size_t at, int size, double value) noexcept {
  const double most = std::exp2(8 * size - 1) - 1;
  const auto counts = std::isfinite(value) ? static_cast<std::int64_t>(std::clamp(std::round(value), -most, most)) : 0;
  for (int i = 0; i < size; ++i) bytes[at + static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(counts >> (8 * i));
}

class KitHandle final : public HidHandle {
 public:
  KitHandle(std::unique_ptr<VendorHandle> device, double rate_Hz)
      : device_(std::move(device)),
        period_(std::chrono::microseconds(static_cast<int>(1e6 / std::max(rate_Hz, 1.0)))) {}

  int read(std::span<std::uint8_t> report, int wait_ms) noexcept override {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) {
      if (wait_ms == 0) return 0;
      std::this_thread::sleep_until(std::min(next_, now + std::chrono::milliseconds(wait_ms)));
      if (std::chrono::steady_clock::now() < next_) return 0;
    }
    next_ = std::max(next_ + period_, now);
    DeviceState state;
    if (!device_->read(state)) return -1;
    return report.size() < kInBytes ? 0 : encode(state, report);
  }

  bool write(std::span<const std::uint8_t> report) noexcept override {
    if (report.size() < kOutBytes) return false;
    const auto number = [&](int index) { return signedValue(bitsAt(report.subspan(1), 16 * index, 16), 16); };
    Force force;
    for (int i = 0; i < 3; ++i) {
      force.force_N[i] = number(i) * 1e-3;
      force.torque_Nmm[i] = number(i + 3) * 0.1;
    }
    return device_->write(force);
  }

 private:
  int encode(const DeviceState& state, std::span<std::uint8_t> report) noexcept {
    std::fill_n(report.begin(), kInBytes, std::uint8_t{0});
    report[0] = 1;
    for (int i = 0; i < 3; ++i)
      put(report, 1 + 4 * static_cast<std::size_t>(i), 4, state.deviceFromStylus.offset[i] * 1000);
    const auto quaternion = haptics::quaternionOf(state.deviceFromStylus.linear);
    for (std::size_t i = 0; i < 4; ++i) put(report, 13 + 2 * i, 2, quaternion[i] * 32767);
    report[21] = static_cast<std::uint8_t>(state.buttons);
    report[22] = static_cast<std::uint8_t>(state.buttons >> 8);
    put(report, 25, 2, ++sequence_ % 32768);
    return static_cast<int>(kInBytes);
  }

  std::unique_ptr<VendorHandle> device_;
  const std::chrono::microseconds period_;
  std::chrono::steady_clock::time_point next_{};
  int sequence_ = 0;
};

class KitBus final : public HidBus {
 public:
  explicit KitBus(std::unique_ptr<VendorKit> kit) : kit_(std::move(kit)) {}

  std::vector<HidFound> list() override {
    const std::string name(kit_->name());
    std::vector<HidFound> all;
    for (const VendorFound& found : kit_->list())
      all.push_back({name + ":" + found.serial, name, found.name, name + ":" + found.serial, kVendor, kProduct, kPage,
                     kUsage, found.limits});
    return all;
  }
  Result<std::unique_ptr<HidHandle>> open(const HidFound& found) override {
    const DeviceLimits limits = found.limits.value_or(DeviceLimits{});
    auto device = kit_->open({found.serial.substr(kit_->name().size() + 1), found.name, limits});
    if (!device) return tl::unexpected(device.error());
    return std::make_unique<KitHandle>(std::move(*device), limits.rate_Hz);
  }

 private:
  std::unique_ptr<VendorKit> kit_;
};

/// Several buses as one; a path belongs to the bus that listed it.
class AllBuses final : public HidBus {
 public:
  explicit AllBuses(std::vector<std::shared_ptr<HidBus>> buses) : buses_(std::move(buses)) {}

  std::vector<HidFound> list() override {
    std::vector<HidFound> all;
    for (const auto& bus : buses_)
      for (HidFound& found : bus->list()) {
        owner_[found.path] = bus.get();
        all.push_back(std::move(found));
      }
    return all;
  }
  Result<std::unique_ptr<HidHandle>> open(const HidFound& found) override {
    const auto owner = owner_.find(found.path);
    if (owner == owner_.end()) return fail(found.path + " is not plugged in.");
    return owner->second->open(found);
  }

 private:
  std::vector<std::shared_ptr<HidBus>> buses_;
  std::map<std::string, HidBus*> owner_;
};

}  // namespace

std::shared_ptr<haptics::HidBus> devicesOf(std::unique_ptr<VendorKit> kit) {
  return std::make_shared<KitBus>(std::move(kit));
}

std::shared_ptr<haptics::HidBus> allDevices() {
  std::vector<std::shared_ptr<HidBus>> buses{usbDevices()};
  for (auto& kit : builtInVendorKits()) buses.push_back(devicesOf(std::move(kit)));
  return std::make_shared<AllBuses>(std::move(buses));
}

}  // namespace insonate
