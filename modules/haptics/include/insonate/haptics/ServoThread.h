#pragma once

#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/HapticServo.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

/// Real-time privileges that the operating system has granted to the thread of the force loop.
struct RealTimeRights {
  bool priority = false;  ///< true: real-time scheduling (SCHED_FIFO) is granted
  bool locked = false;    ///< true: the process's memory is locked (mlockall) and cannot be swapped out
  std::string sentence;   ///< description for the user; says what to do if a privilege is missing
};

/// Timing statistics of the force loop's ticks since the start, or since the last clearTiming().
struct TickTiming {
  std::uint64_t ticks = 0;
  /// number of ticks that began more than a period late; ticks that were due in between were skipped
  std::uint64_t late = 0;
  /// percentiles and maximum of the computing time of a tick, accurate to 3 %
  double p50_us = 0, p99_us = 0, p999_us = 0, max_us = 0;
  /// 99th percentile and maximum of the delay from a tick's due time to its beginning
  double wakeP99_us = 0, wakeMax_us = 0;
};

/// Inputs and outputs of one tick of the force loop.
struct ServoSnapshot {
  std::int64_t time_ns = 0;  ///< time of the tick, CLOCK_MONOTONIC; 0: no tick yet
  std::array<DeviceState, 2> states;
  std::array<bool, 2> present{};
  ServoOutput output;
};

/// Receives the inputs and outputs of each tick on the force loop's thread. onTick() must neither wait nor allocate.
class TickListener {
 public:
  virtual ~TickListener() = default;
  virtual void onTick(const ServoSnapshot& tick) noexcept = 0;
};

/// Runs a HapticServo (the force loop) on a thread of its own, with real-time priority and locked memory if the system
/// allows it. One tick is due every millisecond of CLOCK_MONOTONIC. Late ticks are counted, and missed ticks are
/// skipped. All functions may be called from any thread; none of them makes the force loop wait.
class ServoThread {
 public:
  explicit ServoThread(std::int64_t period_ns = 1'000'000);
  /// Sends a zero force to each device, and stops the thread.
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Sets devices, tools and tissue properties from the next tick on.
  void configure(const ServoSetup& setup);
  /// Sets the tissue near probe and needle from the next tick on.
  void setLocalModel(LocalModel model);
  /// Sets the device that moves a tool (`hand`: probe or needle); null: no device. The previous device receives no more
  /// forces; its own force therefore ends within 100 ms.
  void assignDevice(HapticTool hand, std::shared_ptr<HapticDevice> device);

  /// Sets the object that receives each tick; null: none. The previous listener may receive one more tick.
  void setListener(std::shared_ptr<TickListener> listener);

  /// Returns the real-time privileges that the system has granted to the thread of the force loop.
  RealTimeRights realTimeRights() const;
  /// Returns inputs and outputs of the last tick.
  ServoSnapshot latest() const;
  /// Returns the needle's events (punctures, contacts with bone) since the last call, oldest first; at most the last
  /// 1024.
  std::vector<NeedleEvent> takeEvents();
  /// Returns the timing statistics of the ticks since the start or the last clearTiming().
  TickTiming tickTiming() const;
  void clearTiming();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
