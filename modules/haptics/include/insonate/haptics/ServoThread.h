#pragma once

#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/HapticServo.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

/// Real-time rights that the operating system has granted to the force loop's thread.
struct RealTimeRights {
  bool priority = false;  ///< true: real-time scheduling (SCHED_FIFO) is granted
  bool locked = false;    ///< true: the process's memory is locked (mlockall) and cannot be swapped out
  std::string sentence;   ///< description for the user, with what to do if a right is missing
};

/// Timing statistics of the force loop's ticks since the start, or since the last clearTiming().
struct TickTiming {
  std::uint64_t ticks = 0;
  std::uint64_t late = 0;  ///< ticks that began more than a period late; the ticks missed before them were skipped
  /// percentiles and maximum of a tick's computing time; within 3 %
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

/// Receives the inputs and outputs of each tick on the force loop's thread. ticked() must neither wait nor allocate.
class TickListener {
 public:
  virtual ~TickListener() = default;
  virtual void ticked(const ServoSnapshot& tick) noexcept = 0;
};

/// Runs a HapticServo (the force loop) on its own thread, one tick per millisecond by absolute time, with real-time
/// priority and locked memory if the system allows it. Late ticks are counted, and missed ticks are skipped. All
/// functions may be called from any thread; none makes the force loop wait.
class ServoThread {
 public:
  explicit ServoThread(std::int64_t period_ns = 1'000'000);
  /// Stops the thread after a last zero force to each device.
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  void setup(const ServoSetup& setup);
  void show(LocalModel model);
  /// Sets the device that moves a tool (`hand`: probe or needle); null: none. The former device receives no more
  /// forces, so that its force ends within 100 ms.
  void assign(Hand hand, std::shared_ptr<HapticDevice> device);

  /// Sets the object that receives each tick; null: none. The previous listener may receive one more tick.
  void listen(std::shared_ptr<TickListener> listener);

  RealTimeRights rights() const;
  ServoSnapshot latest() const;
  /// Returns the needle's events (punctures, bone contacts) since the last call, oldest first; only the last 1024 are
  /// kept.
  std::vector<NeedleEvent> takeEvents();
  TickTiming timing() const;
  void clearTiming();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
