#include "servo/RealTime.h"
#include "servo/TickHistogram.h"

#include <insonate/haptics/LatestValue.h>
#include <insonate/haptics/ServoThread.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

namespace insonate {
namespace {

using namespace haptics;

/// Events from the servo's thread to its readers: one writer, and one reader at a time.
class EventRing {
 public:
  void add(const NeedleEvent& event) noexcept {
    const std::uint64_t at = written_.load(std::memory_order_relaxed);
    if (at - read_.load(std::memory_order_acquire) >= ring_.size()) return;  // full: no reader has come for a long time
    ring_[at % ring_.size()] = event;
    written_.store(at + 1, std::memory_order_release);
  }
  std::vector<NeedleEvent> take() {
    std::vector<NeedleEvent> events;
    std::uint64_t at = read_.load(std::memory_order_relaxed);
    for (; at < written_.load(std::memory_order_acquire); ++at) events.push_back(ring_[at % ring_.size()]);
    read_.store(at, std::memory_order_release);
    return events;
  }

 private:
  std::array<NeedleEvent, 1024> ring_{};
  std::atomic<std::uint64_t> written_{0}, read_{0};
};

}  // namespace

struct ServoThread::State {
  using Devices = std::array<std::shared_ptr<HapticDevice>, 2>;

  explicit State(std::int64_t period) : period_ns(period) {}

  void run(const std::stop_token& stop);
  void tick(std::int64_t due_ns);
  void let(const Devices& devices);

  std::int64_t period_ns;
  HapticServo servo;
  LatestValue<Devices> assigned;
  LatestValue<std::shared_ptr<TickListener>> listening;
  LatestValue<ServoSnapshot> snapshots;
  EventRing events;
  TickHistogram work, wake;
  std::atomic<std::uint64_t> late{0};
  std::array<HapticDevice*, 2> inHand{};
  ServoSnapshot snapshot;

  std::mutex writing;          // for setups, models, devices, listeners
  Devices wanted;              // guarded by `writing`
  mutable std::mutex reading;  // for snapshots and events
  mutable std::mutex asking;   // for rights
  RealTimeRights rights;
  std::jthread thread;
};

void ServoThread::State::tick(std::int64_t due_ns) {
  const std::int64_t begin_ns = monotonic_ns();
  const Devices& devices = assigned.read();
  ServoInput input;
  input.now_ns = begin_ns;
  for (int hand = 0; hand < 2; ++hand) {
    HapticDevice* device = devices[hand].get();
    if (device != inHand[hand]) snapshot.states[hand] = {};
    inHand[hand] = device;
    if (device) device->pollState(snapshot.states[hand]);
    snapshot.present[hand] = device && device->phase() == DevicePhase::kStreaming && snapshot.states[hand].time_ns > 0;
  }
  input.tools = snapshot.states;
  input.present = snapshot.present;
  snapshot.output = servo.tick(input);
  snapshot.time_ns = begin_ns;
  for (int hand = 0; hand < 2; ++hand)
    if (devices[hand]) devices[hand]->push(snapshot.output.tools[hand].force);
  for (int i = 0; i < snapshot.output.eventCount; ++i) events.add(snapshot.output.events[i]);
  snapshots.write(snapshot);
  if (const auto& listener = listening.read()) listener->onTick(snapshot);
  work.add(monotonic_ns() - begin_ns);
  wake.add(begin_ns - due_ns);
}

void ServoThread::State::let(const Devices& devices) {
  for (const auto& device : devices)
    if (device) device->push({});
}

void ServoThread::State::run(const std::stop_token& stop) {
  RealTimeRights granted = askForRealTime(this, sizeof *this);
  {
    const std::scoped_lock lock(asking);
    rights = std::move(granted);
  }
  std::int64_t due_ns = monotonic_ns();
  while (!stop.stop_requested()) {
    sleepUntil(due_ns);
    tick(due_ns);
    due_ns += period_ns;
    // A tick that could not begin within its period is late; it begins now, and the missed ticks are skipped.
    if (const std::int64_t behind_ns = monotonic_ns() - due_ns; behind_ns > period_ns) {
      late.fetch_add(1, std::memory_order_relaxed);
      due_ns += behind_ns / period_ns * period_ns;
    }
  }
  let(assigned.read());
}

ServoThread::ServoThread(std::int64_t period_ns)
    : state_(std::make_unique<State>(std::max<std::int64_t>(period_ns, 100'000))) {
  State* state = state_.get();
  state->thread = std::jthread([state](const std::stop_token& stop) { state->run(stop); });
}

ServoThread::~ServoThread() {
  state_->thread.request_stop();
  state_->thread.join();
}

void ServoThread::configure(const ServoSetup& setup) {
  const std::scoped_lock lock(state_->writing);
  state_->servo.configure(setup);
}

void ServoThread::setLocalModel(LocalModel model) {
  const std::scoped_lock lock(state_->writing);
  state_->servo.setLocalModel(std::move(model));
}

void ServoThread::assignDevice(HapticTool hand, std::shared_ptr<HapticDevice> device) {
  const std::scoped_lock lock(state_->writing);
  state_->wanted[hand] = std::move(device);
  state_->assigned.write(state_->wanted);
}

void ServoThread::setListener(std::shared_ptr<TickListener> listener) {
  const std::scoped_lock lock(state_->writing);
  state_->listening.write(std::move(listener));
}

RealTimeRights ServoThread::realTimeRights() const {
  const std::scoped_lock lock(state_->asking);
  return state_->rights;
}

ServoSnapshot ServoThread::latest() const {
  const std::scoped_lock lock(state_->reading);
  return state_->snapshots.read();
}

std::vector<NeedleEvent> ServoThread::takeEvents() {
  const std::scoped_lock lock(state_->reading);
  return state_->events.take();
}

TickTiming ServoThread::tickTiming() const {
  const State& s = *state_;
  return {.ticks = s.work.count(),
          .late = s.late.load(),
          .p50_us = s.work.quantile_us(0.5),
          .p99_us = s.work.quantile_us(0.99),
          .p999_us = s.work.quantile_us(0.999),
          .max_us = s.work.max_us(),
          .wakeP99_us = s.wake.quantile_us(0.99),
          .wakeMax_us = s.wake.max_us()};
}

void ServoThread::clearTiming() {
  state_->work.clear();
  state_->wake.clear();
  state_->late = 0;
}

}  // namespace insonate
