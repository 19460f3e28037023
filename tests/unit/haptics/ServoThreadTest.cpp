#include "NeedleRig.h"
#include "servo/RealTime.h"
#include "servo/TickHistogram.h"

#include <insonate/haptics/ServoThread.h>
#include <insonate/haptics/SimulatedHand.h>

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace insonate::haptics {
namespace {

using namespace std::chrono_literals;

/// Stands where it is told; remembers the last force.
class StillDevice : public HapticDevice {
 public:
  explicit StillDevice(Vec3 at) : at_mm_(at) { info_.limits = deviceProfiles()[0].limits; }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_; }
  std::string error() const override { return {}; }
  DeviceCounters counters() const noexcept override { return {}; }
  bool pollState(DeviceState& state) noexcept override {
    // Creeps toward its place, as a hand would.
    now_mm_ = now_mm_ + (at_mm_ - now_mm_) * 0.02;
    state = {.deviceFromStylus = {{}, now_mm_},
             .velocity_mmps = {},
             .angularVelocity_radps = {},
             .buttons = 0,
             .time_ns = monotonic_ns()};
    if (slow) std::this_thread::sleep_for(5ms);
    return true;
  }
  void push(const Force& force) noexcept override { pushed_N = norm(force.force_N); }

  std::atomic<DevicePhase> phase_ = DevicePhase::kStreaming;
  std::atomic<double> pushed_N = -1;
  std::atomic<bool> slow = false;

 private:
  DeviceInfo info_;
  Vec3 at_mm_, now_mm_{0, 0, -10};
};

LocalModel skinAtZero() {
  LocalModel model;
  model.time_ns = monotonic_ns();
  model.patchCount = 1;
  model.patches[0] = {{}, {}, {0, 0, -1}, 0.3, 0};
  return model;
}

/// Shows the model as long as `go` says, for ten seconds at most.
template <class Go>
bool showWhile(ServoThread& servo, const Go& go) {
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (std::chrono::steady_clock::now() < end) {
    servo.setLocalModel(skinAtZero());
    if (!go()) return true;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

/// The probe's hand, 4 mm below the skin.
std::shared_ptr<StillDevice> pressIn(ServoThread& servo) {
  const auto device = std::make_shared<StillDevice>(Vec3{0, 0, 4});
  ServoSetup setup;
  setup.needle = *loadNeedleTable("measured");
  for (ToolSetup& hand : setup.tools) hand.limits = device->info().limits;
  servo.configure(setup);
  servo.assignDevice(kProbeTool, device);
  return device;
}

TEST(TickHistogram, QuantilesWithinItsBuckets) {
  TickHistogram histogram;
  for (int i = 1; i <= 1000; ++i) histogram.add(i * 1000);
  EXPECT_EQ(histogram.count(), 1000U);
  EXPECT_NEAR(histogram.quantile_us(0.5), 500, 15);
  EXPECT_NEAR(histogram.quantile_us(0.99), 990, 30);
  EXPECT_DOUBLE_EQ(histogram.quantile_us(1), 1000);
  histogram.clear();
  EXPECT_EQ(histogram.count(), 0U);
  EXPECT_EQ(histogram.quantile_us(0.5), 0);
}

TEST(ServoThread, PushesADeviceAndLetsGoOfItWhenItIsLost) {
  ServoThread servo;
  const auto device = pressIn(servo);
  ASSERT_TRUE(showWhile(servo, [&] { return device->pushed_N < 1; }));
  EXPECT_GT(servo.latest().output.skinForce_N, 1);
  device->phase_ = DevicePhase::kLost;
  EXPECT_TRUE(showWhile(servo, [&] { return device->pushed_N != 0; }));
  EXPECT_FALSE(servo.latest().present[kProbeTool]);
}

TEST(ServoThread, ForcesEndWhenTheModelStops) {
  ServoThread servo;
  const auto device = pressIn(servo);
  ASSERT_TRUE(showWhile(servo, [&] { return device->pushed_N < 1; }));
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (device->pushed_N > 0 && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(device->pushed_N, 0);
}

TEST(ServoThread, LateTicksAreCountedAndSurvived) {
  ServoThread servo;
  const auto device = std::make_shared<StillDevice>(Vec3{0, 0, 4});
  servo.assignDevice(kProbeTool, device);
  device->slow = true;
  ASSERT_TRUE(showWhile(servo, [&] { return servo.tickTiming().late < 20; }));
  device->slow = false;
  servo.clearTiming();
  ASSERT_TRUE(showWhile(servo, [&] { return servo.tickTiming().ticks < 100; }));
  EXPECT_LT(servo.tickTiming().p50_us, 4000);
}

TEST(ServoThread, SaysWhatTheSystemGrants) {
  ServoThread servo;
  ASSERT_TRUE(showWhile(servo, [&] { return servo.realTimeRights().sentence.empty(); }));
  const RealTimeRights rights = servo.realTimeRights();
  const auto& sentence = rights.sentence;
  EXPECT_EQ(sentence == "The servo runs with real-time priority and locked memory.", rights.priority && rights.locked);
  EXPECT_EQ(sentence.find("without real-time priority") != std::string::npos, !rights.priority);
  EXPECT_EQ(sentence.find("memlock") != std::string::npos, !rights.locked);
}

}  // namespace
}  // namespace insonate::haptics
