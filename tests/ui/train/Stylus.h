#pragma once

#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/SimulatedHand.h>

#include <atomic>
#include <chrono>
#include <cmath>

namespace insonate::train {

/// A stylus with two buttons, as a test holds it.
class Stylus final : public HapticDevice {
 public:
  Stylus() {
    info_.id = "stylus", info_.name = "Stylus";
    info_.limits = deviceProfiles().front().limits;
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return DevicePhase::kStreaming; }
  std::string error() const override { return {}; }
  DeviceCounters counters() const noexcept override { return {}; }
  bool pollState(DeviceState& state) noexcept override {
    const double turn = turn_rad.load();
    state = {};
    const Vec3 x{std::cos(turn), 0, -std::sin(turn)}, y{0, 1, 0};
    state.deviceFromStylus = {{{x, y, cross(x, y)}}, {x_mm, y_mm, z_mm}};
    state.buttons = buttons;
    state.time_ns = std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
    return true;
  }
  void push(const Force&) noexcept override {}

  std::atomic<double> turn_rad = 0;  ///< about the device's y
  std::atomic<double> x_mm = 0, y_mm = 0, z_mm = 0;
  std::atomic<std::uint32_t> buttons = 0;

 private:
  DeviceInfo info_;
};

}  // namespace insonate::train
