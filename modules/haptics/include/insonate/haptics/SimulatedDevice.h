#pragma once

#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/LatestValue.h>
#include <insonate/haptics/SimulatedHand.h>

#include <atomic>
#include <string>

namespace insonate {

/// A device that is not there, in a hand that is not there: the force of the servo meets mass, friction and grip, and
/// the stylus goes where that takes it. Lives on the servo's calls of take(), as far as time has gone on.
class SimulatedDevice : public HapticDevice {
 public:
  SimulatedDevice(std::string id, const DeviceProfile& profile, const Grip& grip, const HandPath::Point& start);

  /// Sets the place that the hand aims at from now on; from one thread. Used by the hands of mouse and keyboard.
  void want(const HandPath::Point& point);
  /// A path instead, over and over, its times counted from the call.
  void follow(HandPath path);
  /// Pulled out of its socket, and put in again.
  void plug(bool in) { phase_ = in ? DevicePhase::kStreaming : DevicePhase::kLost; }

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_; }
  std::string trouble() const override;
  DeviceCounters counters() const noexcept override { return {taken_, pushed_, 0, 0}; }
  bool take(DeviceState& state) noexcept override;
  void push(const Force& force) noexcept override;

  /// Least energy that the hand had put into device and servo at any moment of a contact; 0 or above when passive.
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
