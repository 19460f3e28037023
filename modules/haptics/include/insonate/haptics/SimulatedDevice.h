#pragma once

#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/LatestValue.h>
#include <insonate/haptics/SimulatedHand.h>

#include <atomic>
#include <string>

namespace insonate {

/// A simulated device in a simulated hand: the servo's force acts on mass, friction and grip, which determine the
/// stylus's motion. The simulation advances in take(), up to the present time.
class SimulatedDevice : public HapticDevice {
 public:
  SimulatedDevice(std::string id, const DeviceProfile& profile, const Grip& grip, const HandPath::Point& start);

  /// Sets the place to which the hand moves. Call it on one thread. Mouse and keyboard use this.
  void want(const HandPath::Point& point);
  /// Lets the hand follow a path instead, repeatedly; times count from this call.
  void follow(HandPath path);
  /// Simulates plugging the device in, or unplugging it.
  void plug(bool in) { phase_ = in ? DevicePhase::kStreaming : DevicePhase::kLost; }

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_; }
  std::string trouble() const override;
  DeviceCounters counters() const noexcept override { return {taken_, pushed_, 0, 0}; }
  bool take(DeviceState& state) noexcept override;
  void push(const Force& force) noexcept override;

  /// Minimum, over all moments of a contact, of the energy that the hand had put into device and servo; 0 or above if
  /// the loop is passive.
  double leastEnergy_J() const { return least_J_; }

 private:
  struct Intent {
    HandPath path;
    std::int64_t begin_ns = 0;
  };

  DeviceInfo info_;
  std::atomic<DevicePhase> phase_ = DevicePhase::kStreaming;
  LatestValue<Intent> intent_;
  SimulatedHand hand_;
  PassivityObserver observer_;
  Force force_;
  std::int64_t time_ns_ = 0;
  std::atomic<std::uint64_t> taken_ = 0, pushed_ = 0;
  std::atomic<double> least_J_ = 0;
};

}  // namespace insonate
