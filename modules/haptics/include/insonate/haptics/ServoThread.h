#pragma once

#include <insonate/haptics/HapticDevice.h>
#include <insonate/haptics/HapticServo.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

/// Rights that the system grants to the servo's thread.
struct RealTimeRights {
  bool priority = false;  ///< SCHED_FIFO
  bool locked = false;    ///< its memory stays in place
  std::string sentence;   ///< for people: what it is, and what to do where something is missing
};

/// Timing of the ticks since the start, or since the last clearTiming().
struct TickTiming {
  std::uint64_t ticks = 0;
  std::uint64_t late = 0;  ///< ticks that began more than a period after their time; those in between were left out
  double p50_us = 0, p99_us = 0, p999_us = 0, max_us = 0;  ///< of the work of a tick; within 3 %
  double wakeP99_us = 0, wakeMax_us = 0;                   ///< from when it should have begun to when it did
};

/// Inputs and outputs of the servo's last tick.
struct ServoSnapshot {
  std::int64_t time_ns = 0;  ///< 0: none yet
  std::array<DeviceState, 2> states;
  std::array<bool, 2> present{};
  ServoOutput output;
};

/// Hears of each tick on the servo's own thread: it must neither wait nor allocate.
class TickListener {
 public:
  virtual ~TickListener() = default;
  virtual void ticked(const ServoSnapshot& tick) noexcept = 0;
};

/// Runs a HapticServo on a thread of its own, a tick a millisecond by absolute time, with real-time priority and
/// locked memory if the system allows it. A late tick is counted, and ticks that it missed are skipped. All functions
/// may be called from any thread; none makes the servo wait.
class ServoThread {
 public:
  explicit ServoThread(std::int64_t period_ns = 1'000'000);
  /// Stops, after a last zero force.
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  void setup(const ServoSetup& setup);
  void show(LocalModel model);
  /// Sets the device in a hand, or none. The former device gets no more forces, and so releases its force within 100
  /// ms.
  void assign(Hand hand, std::shared_ptr<HapticDevice> device);

  /// Sets the listener of the ticks, or none. The previous listener may receive one more tick.
  void listen(std::shared_ptr<TickListener> listener);

  RealTimeRights rights() const;
  ServoSnapshot latest() const;
  /// Since the last call, the oldest first; the last 1024 at most.
  std::vector<NeedleEvent> takeEvents();
  TickTiming timing() const;
  void clearTiming();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
