#include "HandsBench.h"
#include "support/Allocations.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

namespace insonate {
namespace {

using namespace std::chrono_literals;
using test::eventually;
using test::Frame;
using test::pressedBy;
using Bench = test::HandsBench;

TEST(HapticSession, TheProbeFeelsWithWhatForceTheTissueOfThePicturePressesBack) {
  Bench bench;
  const auto device = bench.probeDevice();
  for (const double in_mm : {3.0, 6.0, 4.0}) {
    bench.hands.moveByMouse(kProbeTool, pressedBy(in_mm));
    double felt_N = 0, solved_N = 1, apart_mm = 1;
    EXPECT_TRUE(eventually([&] {
      const ServoSnapshot now = bench.hands.snapshot();
      const Frame frame = bench.live->latest();
      felt_N = now.output.skinForce_N, solved_N = frame->press.force_N;
      apart_mm = norm(now.output.tools[kProbeTool].patientFromTool.offset - frame->patientFromProbe.offset);
      return frame->press.settled && solved_N > 0.2 && apart_mm < 0.05 && std::abs(felt_N - solved_N) < 0.05 * solved_N;
    })) << in_mm
        << " mm: felt " << felt_N << " N, solved " << solved_N << " N, " << apart_mm << " mm apart";
  }
  EXPECT_GT(bench.live->latest()->patientFromProbe.offset.y, 1) << "the device's hand leads the picture's probe";
  // The hand's target and the place that the tissue permits differ by the force over the grip's stiffness.
  const double wanted_mm = pressedBy(4).offset.y, is_mm = bench.live->latest()->patientFromProbe.offset.y;
  EXPECT_LT(is_mm, wanted_mm - 0.3);
  EXPECT_GE(device->minEnergy_J(), 0);
}

TEST(HapticSession, UnpluggedInContactLeavesNoForceAndThePictureWhereItWas) {
  Bench bench;
  const auto device = bench.probeDevice();
  bench.hands.moveByMouse(kProbeTool, pressedBy(5));
  ASSERT_TRUE(eventually([&] { return bench.hands.snapshot().output.skinForce_N > 0.3; }));
  device->setConnected(false);
  ASSERT_TRUE(eventually([&] { return !bench.hands.snapshot().present[kProbeTool]; }));
  EXPECT_EQ(norm(bench.hands.snapshot().output.tools[kProbeTool].force.force_N), 0);
  EXPECT_EQ(bench.hands.snapshot().output.skinForce_N, 0);
  EXPECT_TRUE(eventually([&] {
    const Transform pose = bench.live->latest()->patientFromProbe;
    std::this_thread::sleep_for(300ms);
    return bench.live->latest()->patientFromProbe == pose;
  }));
  bench.hands.moveByMouse(kProbeTool, pressedBy(2));
  device->setConnected(true);
  EXPECT_TRUE(eventually([&] { return bench.hands.snapshot().present[kProbeTool]; }));
}

TEST(HapticSession, TheNeedleOfMouseAndKeysPuncturesEachWallOnceThereAndBack) {
  Bench bench;
  NeedlePlacement needle = bench.takeNeedle();
  ASSERT_TRUE(eventually([&] { return bench.hands.snapshot().present[kNeedleTool]; }));
  bench.push(needle, 12);
  const NeedleState inside = bench.hands.snapshot().output.needle;
  EXPECT_EQ(inside.in, kVein);
  EXPECT_NEAR(inside.depth_mm, 12, 3) << "less what the skin was pushed ahead";
  bench.push(needle, 24);
  bench.push(needle, -5);
  std::vector<std::pair<NeedleEventKind, Label>> said;
  for (const NeedleEvent& event : bench.events) said.emplace_back(event.kind, event.wall);
  using enum NeedleEventKind;
  EXPECT_THAT(said, testing::ElementsAre(std::pair{Entered, kSkin}, std::pair{Entered, kVein}, std::pair{Left, kVein},
                                         std::pair{Withdrawn, kVein}, std::pair{Withdrawn, kVein},
                                         std::pair{Withdrawn, kSkin}));
  EXPECT_FALSE(bench.hands.snapshot().output.needle.inBody);
}

TEST(HapticSession, ThePictureHasTheNeedleWhereItIsHeldAndTheServoTheTissueAsItIsPressed) {
  Bench bench;
  NeedlePlacement needle = bench.takeNeedle();
  bench.push(needle, 9);
  const auto sameTip = [&] {
    const Frame frame = bench.live->latest();
    return frame->needle && norm(frame->needle->tip_mm - needle.patientFromNeedle().offset) < 0.05;
  };
  EXPECT_TRUE(eventually(sameTip));
  EXPECT_NEAR(bench.live->latest()->needle->bevelNormal.x, -needle.patientFromNeedle().linear.column[1].x, 1e-6);
  EXPECT_EQ(bench.live->latest()->press.restFromPatient, Transform{}) << "nothing presses";
  const double before_mm = bench.hands.snapshot().output.needle.depth_mm;
  bench.live->setPose(pressedBy(4));
  Vec3 rest_mm;
  EXPECT_TRUE(eventually([&] {
    const Frame frame = bench.live->latest();
    rest_mm = frame->press.restFromPatient * frame->needle->tip_mm;
    return frame->press.settled && frame->press.force_N > 0.2 && rest_mm.y < frame->needle->tip_mm.y - 1;
  })) << "tissue came "
      << bench.live->latest()->needle->tip_mm.y - rest_mm.y << " mm toward the tip";
  EXPECT_TRUE(eventually([&] { return bench.hands.snapshot().output.needle.depth_mm < before_mm - 1; }))
      << "the skin went down along the needle";
  bench.hands.assignDevice(kNeedleTool, nullptr, {});
  EXPECT_TRUE(eventually([&] { return !bench.live->latest()->needle; }));
}

/// Otherwise a tick sees the needle somewhere between, perhaps in the patient.
TEST(HapticSession, AJumpOfTheMouseIsSeenWholeOrNotAtAll) {
  Bench bench;
  NeedlePlacement needle = bench.takeNeedle();
  const Transform near = needle.patientFromNeedle();
  needle.tilt(-60);
  Transform far = needle.patientFromNeedle();
  far.offset = far.offset - near.linear.column[2] * 12.0;
  ASSERT_TRUE(eventually([&] { return bench.hands.snapshot().present[kNeedleTool]; }));
  bench.hands.moveByMouse(kNeedleTool, near);
  std::this_thread::sleep_for(500ms);
  std::atomic<bool> done{false};
  std::thread moving([&] {
    for (int i = 0; i < 4000; ++i) {
      bench.hands.moveByMouse(kNeedleTool, i % 2 ? near : far);
      std::this_thread::sleep_for(std::chrono::microseconds(i % 7 * 100));
    }
    done = true;
  });
  int between = 0;
  while (!done) {
    const Vec3 tip_mm = bench.hands.snapshot().output.tools[kNeedleTool].patientFromTool.offset;
    between += norm(tip_mm - near.offset) > 0.01 && norm(tip_mm - far.offset) > 0.01;
  }
  moving.join();
  EXPECT_EQ(between, 0);
}

TEST(HapticSession, ATypedDepthIsReachedThroughTheWallsAndNotBeyondThem) {
  Bench bench;
  NeedlePlacement needle = bench.takeNeedle();
  ASSERT_TRUE(eventually([&] { return bench.hands.snapshot().present[kNeedleTool]; }));
  needle.advance(17);  // all at once
  bench.hands.moveByMouse(kNeedleTool, needle.patientFromNeedle());
  EXPECT_TRUE(eventually([&] { return bench.hands.snapshot().output.needle.in == kVein; }));
}

TEST(HapticSession, AHeldNeedleStaysWhateverTheHandDoesAndGoesOnFromThereOnceItIsLetGo) {
  Bench bench;
  NeedlePlacement needle = NeedlePlacement::makeBeside(bench.probe, 19, NeedlePlane::InPlane, {});
  needle.moveTo({0, -0.5, 0});
  needle.tilt(90 - needle.state().angle_deg);
  const auto device = std::make_shared<SimulatedDevice>("needle", deviceProfiles()[3], Grip{}, HandPath::Point{});
  ToolSetup setup;
  setup.patientFromDevice.offset = needle.patientFromNeedle().offset;
  setup.stylusFromTool.linear = needle.patientFromNeedle().linear;
  bench.hands.assignDevice(kNeedleTool, device, setup);
  ASSERT_TRUE(eventually([&] { return bench.hands.snapshot().present[kNeedleTool]; }));
  bench.push(needle, 14);
  ASSERT_EQ(bench.hands.snapshot().output.needle.in, kVein);
  const auto tip = [&] { return bench.hands.snapshot().output.tools[kNeedleTool].patientFromShown.offset; };
  bench.hands.setNeedleFixed(true);
  std::this_thread::sleep_for(100ms);
  const Vec3 frozen = tip();
  const auto hand = [&] { return bench.hands.snapshot().states[kNeedleTool].deviceFromStylus.offset; };
  const Vec3 before = hand();
  bench.events.clear();
  // Far through the back wall, and turned.
  device->setTarget({0, {3, 20, 2}, {{Vec3{1, 0, 0}, Vec3{0, 0.98, 0.199}, Vec3{0, -0.199, 0.98}}}});
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(tip(), frozen);
  EXPECT_GT(norm(hand() - before), 0.2) << "the hand yields a little";
  EXPECT_GT(norm(bench.hands.snapshot().output.tools[kNeedleTool].wanted_N), 0.5) << "and is drawn back";
  const Vec3 axis = bench.hands.snapshot().output.tools[kNeedleTool].patientFromShown.linear.column[2];
  bench.hands.setNeedleFixed(false);
  std::this_thread::sleep_for(50ms);
  EXPECT_LT(norm(tip() - frozen), 2) << "it went on from there";
  EXPECT_GT(dot(bench.hands.snapshot().output.tools[kNeedleTool].patientFromShown.linear.column[2], axis), 0.99);
  for (const NeedleEvent& event : bench.hands.takeEvents()) bench.events.push_back(event);
  EXPECT_TRUE(bench.events.empty()) << "nothing was punctured while it was held";
  // Drawn back by the hand, it comes out by the way it went in.
  device->setTarget({0, {3, -30, 2}, {{Vec3{1, 0, 0}, Vec3{0, 0.98, 0.199}, Vec3{0, -0.199, 0.98}}}});
  EXPECT_TRUE(eventually([&] { return !bench.hands.snapshot().output.needle.inBody; }));
}

TEST(HapticSession, ATestForceIsFeltForASecondAndThenTheHandIsTheServosAgain) {
  /// Remembers what it was pushed with.
  class Listener : public HapticDevice {
   public:
    Listener() { info_.limits = deviceProfiles()[0].limits; }
    const DeviceInfo& info() const noexcept override { return info_; }
    DevicePhase phase() const noexcept override { return DevicePhase::kStreaming; }
    std::string error() const override { return {}; }
    DeviceCounters counters() const noexcept override { return {}; }
    bool pollState(DeviceState& state) noexcept override {
      state = {};
      state.time_ns = std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
      return true;
    }
    void push(const Force& force) noexcept override {
      last_N = norm(force.force_N);
      if (last_N > max_N) max_N = last_N.load();
    }
    std::atomic<double> last_N = 0, max_N = 0;

   private:
    DeviceInfo info_;
  };
  Bench bench;
  const auto device = std::make_shared<Listener>();
  ToolSetup setup;
  setup.patientFromDevice.offset = {0, -30, 0};
  bench.hands.assignDevice(kProbeTool, device, setup);
  ASSERT_TRUE(eventually([&] { return bench.hands.snapshot().present[kProbeTool]; }));
  bench.hands.testForce(kProbeTool, {0, 5, 0});
  EXPECT_TRUE(eventually([&] { return device->last_N > 0.9; }));
  EXPECT_TRUE(eventually([&] { return device->last_N == 0 && bench.hands.snapshot().present[kProbeTool]; }));
  EXPECT_NEAR(device->max_N, 1, 1e-9) << "no more than a newton";
}

/// Both hands move: ticks, the steps that show them the tissue, the image and its needle. What begins seldom (another
/// scene) asks for memory, so that the quietest of many rounds tells.
TEST(HapticSession, StepsOfBothHandsAndTheirPicturesAllocateNothing) {
  LiveOptions options;
  options.workAhead = false;    // scenes to come are made of memory
  options.cineBytes = 300'000;  // some frames, so that they are soon used again
  Bench bench(options);
  const auto probe = bench.probeDevice();
  NeedlePlacement needle = bench.takeNeedle();
  bench.push(needle, 12);
  probe->follow({{{0, {0, 3, 0}, {}}, {1, {0, 5, 0}, {}}, {2, {0, 3, 0}, {}}}});
  ASSERT_TRUE(eventually([&] { return bench.live->latest()->needle && bench.live->latest()->press.force_N > 0.1; }));
  const Transform tip = needle.patientFromNeedle();
  const auto move = [&] {
    for (int i = 0; i < 20; ++i) {
      Transform now = tip;
      now.offset.y += i % 2 ? 0.3 : -0.3;
      bench.hands.moveByMouse(kNeedleTool, now);
      std::this_thread::sleep_for(20ms);
    }
  };
  for (int i = 0; i < 5; ++i) move();
  long least = 1000;
  std::uint64_t pictures = 0;
  for (int round = 0; round < 60 && least > 0; ++round) {
    const std::uint64_t first = bench.live->latest()->number;
    const long before = test::allocations();
    move();
    const long asked = test::allocations() - before;
    if (asked < least) least = asked, pictures = bench.live->latest()->number - first;
  }
  EXPECT_EQ(least, 0);
  EXPECT_GT(pictures, 3U) << "they followed";
}

TEST(HapticSession, EmptyHandsCostNothingAndItEndsInTheMiddleOfEverything) {
  auto bench = std::make_unique<Bench>();
  EXPECT_EQ(bench->hands.snapshot().time_ns, 0);
  EXPECT_EQ(bench->hands.tickTiming().ticks, 0U);
  bench->probeDevice();
  NeedlePlacement needle = NeedlePlacement::makeBeside(bench->probe, 19, NeedlePlane::OutOfPlane, {});
  bench->hands.assignMouse(kNeedleTool, needle.patientFromNeedle());
  ASSERT_TRUE(eventually([&] { return bench->hands.tickTiming().ticks > 20; }));
  bench->hands.setCase(CaseVolumes(bench->patient).labels, &bench->probe);  // tissue in the making
  bench = nullptr;
}

}  // namespace
}  // namespace insonate
