#pragma once

#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/LatestValue.h>
#include <insonate/haptics/SimulatedHand.h>

#include <atomic>
#include <string>

namespace insonate {

/// A simulated haptic device that a simulated hand holds. The force of the force loop, the mass and friction of the
/// device, and the grip of the hand (spring and damper) determine the motion of the stylus. Each pollState() advances
/// the simulation to the present time.
class SimulatedDevice : public HapticDevice {
 public:
  SimulatedDevice(std::string id, const DeviceProfile& profile, const Grip& grip, const HandPath::Point& start);

  /// Sets the pose to which the simulated hand moves, e.g. as requested by mouse and keys. Call setTarget() and
  /// follow() on one thread.
  void setTarget(const HandPath::Point& point);
  /// Lets the simulated hand follow a path, repeatedly, until the next call of setTarget(). Times of the path count
  /// from this call.
  void follow(HandPath path);
  /// Simulates that the device is plugged in (true) or unplugged (false).
  void setConnected(bool in) { phase_ = in ? DevicePhase::kStreaming : DevicePhase::kLost; }

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_; }
  std::string error() const override;
  DeviceCounters counters() const noexcept override { return {taken_, pushed_, 0, 0}; }
  bool pollState(DeviceState& state) noexcept override;
  void push(const Force& force) noexcept override;

  /// Returns the minimum, over time, of the net energy that the hand has put into device and force loop since a contact
  /// began. The minimum is 0 if the force loop is passive, and negative if the loop has returned more energy than it
  /// received.
  double minEnergy_J() const { return minEnergy_J_; }

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
  std::atomic<double> minEnergy_J_ = 0;
};

}  // namespace insonate
