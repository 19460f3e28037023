#include "LoopRig.h"
#include "servo/ToolContact.h"
#include "support/Allocations.h"

#include <limits>

namespace insonate::haptics {
namespace {

constexpr DeviceLimits strongDevice() {
  DeviceLimits device;
  device.sensedAxes = 6, device.forceAxes = 3;
  device.maxForce_N = 20, device.maxStiffness_Npmm = 3, device.rate_Hz = 1000;
  device.damping_Nspm = 2, device.friction_N = 0.5, device.mass_kg = 0.2;
  return device;
}
constexpr DeviceLimits kStrong = strongDevice();

/// Both tools held still where they are told, for as long as it takes forces to come up.
struct Held {
  explicit Held(const DeviceLimits& device = kStrong) {
    for (ToolSetup& hand : setup.tools) hand.limits = device;
    setup.needle = *loadNeedleTable("measured");
    servo.configure(setup);
  }
  ServoOutput hold(Vec3 probe, Vec3 needle, int ticks, bool shows = true) {
    for (int i = 0; i < ticks; ++i) {
      time_ns += 1'000'000;
      if (shows) servo.setLocalModel(modelOf(grid, time_ns));
      ServoInput input{.now_ns = time_ns, .tools = {}, .present = present};
      const std::array<Vec3, 2> at{probe, needle};
      for (int h = 0; h < 2; ++h) {
        // Approached, so that the account has seen the way.
        last[h] = last[h] + (at[h] - last[h]) * 0.05;
        input.tools[h].deviceFromStylus.offset = last[h];
        input.tools[h].time_ns = statesCome ? time_ns : 1;
      }
      out = servo.tick(input);
    }
    return out;
  }

  std::shared_ptr<const TissueGrid> grid = layerOf(kMuscle);
  ServoSetup setup;
  HapticServo servo;
  ServoOutput out;
  std::array<bool, 2> present{true, true};
  bool statesCome = true;
  std::array<Vec3, 2> last{Vec3{-80, 0, -20}, Vec3{0, 0, -20}};
  std::int64_t time_ns = 1'000'000'000;
};

TEST(Servo, TheSkinPushesTheProbeBackAsItsPatchesSay) {
  Held held;
  const ServoOutput out = held.hold({-80, 0, 5}, {0, 0, -20}, 400);
  // Three points of the face, each 0.1 * 5 + 0.01 * 25 N.
  EXPECT_NEAR(out.skinForce_N, 3 * 0.75, 0.01);
  EXPECT_NEAR(out.tools[kProbeTool].force.force_N.z, -2.25, 0.02);
  EXPECT_NEAR(out.skinIndent_mm, 5, 0.01);
  EXPECT_FALSE(out.tools[kProbeTool].limited);
  EXPECT_EQ(norm(held.hold({-80, 0, -20}, {0, 0, -20}, 400).tools[kProbeTool].force.force_N), 0);
}

TEST(Servo, NothingIsFeltInTheAir) {
  Held held;
  const ServoOutput out = held.hold({-80, 0, -20}, {0, 0, -20}, 10);
  for (const ToolOutput& hand : out.tools) {
    EXPECT_EQ(norm(hand.force.force_N), 0);
    EXPECT_FALSE(hand.limited);
  }
}

TEST(Servo, ForcesStayWithinTheDevice) {
  DeviceLimits weak = kStrong;
  weak.maxForce_N = 1;
  Held held(weak);
  const ServoOutput out = held.hold({-80, 0, 9}, {0, 0, -20}, 400);
  EXPECT_NEAR(norm(out.tools[kProbeTool].force.force_N), 1, 1e-9);
  EXPECT_TRUE(out.tools[kProbeTool].limited);
  EXPECT_GT(norm(out.tools[kProbeTool].wanted_N), 3);
}

TEST(Servo, SilenceOfTheModelOrOfTheDeviceEndsInNothingWithin100Milliseconds) {
  for (const bool modelStops : {true, false}) {
    Held held;
    held.hold({-80, 0, 5}, {0, 0, -20}, 400);
    if (!modelStops) {
      held.statesCome = false;
    }
    const ServoOutput out = held.hold({-80, 0, 5}, {0, 0, -20}, 100, !modelStops);
    EXPECT_EQ(norm(out.tools[kProbeTool].force.force_N), 0) << modelStops;
  }
}

TEST(Servo, ALostDeviceGetsNoForceAtOnce) {
  Held held;
  EXPECT_GT(norm(held.hold({-80, 0, 5}, {0, 0, -20}, 400).tools[kProbeTool].force.force_N), 2);
  held.present[kProbeTool] = false;
  EXPECT_EQ(norm(held.hold({-80, 0, 5}, {0, 0, -20}, 1).tools[kProbeTool].force.force_N), 0);
  EXPECT_EQ(held.out.skinForce_N, 0);
  // Taken up again, the force comes back no faster than it may.
  held.present[kProbeTool] = true;
  EXPECT_LE(norm(held.hold({-80, 0, 5}, {0, 0, -20}, 1).tools[kProbeTool].force.force_N), 0.5);
}

TEST(Servo, HandsApartMovesTheToolAndNotTheForce) {
  Held held;
  held.setup.tools[kProbeTool].apart_mm = {-30, 0, 2};
  held.setup.tools[kProbeTool].patientFromDevice.linear = {{Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}}};
  held.servo.configure(held.setup);
  const ServoOutput out = held.hold({0, 80, 3}, {0, 0, -20}, 400);
  const Vec3 tool = out.tools[kProbeTool].patientFromTool.offset;
  EXPECT_NEAR(tool.x, -80, 1e-6);
  EXPECT_NEAR(tool.y, -30, 1e-6);
  EXPECT_NEAR(tool.z, 5, 1e-6);
  EXPECT_NEAR(out.tools[kProbeTool].force.force_N.z, -2.25, 0.03);
}

TEST(Servo, ProbeAndNeedlePushEachOtherAway) {
  Held held;
  // The needle stands beside the handle, 5 mm off its axis: 1.635 mm too near.
  const ServoOutput out = held.hold({0, 0, -40}, {5, 0, -60}, 600);
  const double fx = out.tools[kNeedleTool].force.force_N.x;
  EXPECT_NEAR(fx, 1.5 * 1.635, 0.05);
  EXPECT_NEAR(out.tools[kProbeTool].force.force_N.x, -fx, 1e-6);
}

TEST(ToolContact, NearestPointsOfTwoLines) {
  const NearestPoints crossing = nearestPoints({{-1, 0, 0}, {1, 0, 0}, 0}, {{0.5, -1, 2}, {0.5, 1, 2}, 0});
  EXPECT_NEAR(norm(crossing.onA - Vec3{0.5, 0, 0}) + norm(crossing.onB - Vec3{0.5, 0, 2}), 0, 1e-12);
  const NearestPoints ends = nearestPoints({{0, 0, 0}, {1, 0, 0}, 0}, {{3, 1, 0}, {5, 4, 0}, 0});
  EXPECT_NEAR(norm(ends.onA - Vec3{1, 0, 0}) + norm(ends.onB - Vec3{3, 1, 0}), 0, 1e-12);
  const NearestPoints parallel = nearestPoints({{0, 0, 0}, {4, 0, 0}, 0}, {{1, 2, 0}, {3, 2, 0}, 0});
  EXPECT_NEAR(norm(parallel.onA - parallel.onB), 2, 1e-12);
  const NearestPoints point = nearestPoints({{0, 0, 0}, {0, 0, 0}, 0}, {{1, 2, 0}, {1, -2, 0}, 0});
  EXPECT_NEAR(norm(point.onA - point.onB), 1, 1e-12);
}

TEST(ToolContact, ANeedleThatIsPushedPastTheAxisStaysOnItsSide) {
  ToolContact contact;
  Transform probe, needle;
  Force onProbe, onNeedle;
  for (double x = 8; x > -3; x -= 0.5) {
    onProbe = onNeedle = {};
    needle.offset = {x, 0, -40};
    contact.push(probe, needle, {}, 1, onProbe, onNeedle);
  }
  EXPECT_GT(onNeedle.force_N.x, 6);
}

TEST(Servo, AHeldNeedleStaysAndItsHandIsDrawnBackUntilItIsLetGo) {
  Held held;
  held.hold({-80, 0, -20}, {0, 0, 8}, 400);
  const NeedleState before = held.out.needle;
  const Transform tool = held.out.tools[kNeedleTool].patientFromTool;
  ASSERT_TRUE(before.inBody);
  held.setup.needleFixed = true;
  held.servo.configure(held.setup);
  held.hold({-80, 0, -20}, {0, 0, 8}, 1);
  held.hold({-80, 0, -20}, {0.4, 0, 8.5}, 400);
  EXPECT_LT(norm(held.out.tools[kNeedleTool].patientFromTool.offset - tool.offset), 1e-3);
  EXPECT_NEAR(held.out.needle.depth_mm, before.depth_mm, 1e-3);
  EXPECT_EQ(held.out.eventCount, 0);
  // Half of what the device can show, 3 N/mm.
  EXPECT_NEAR(held.out.tools[kNeedleTool].wanted_N.x, -1.5 * 0.4, 0.01);
  EXPECT_NEAR(held.out.tools[kNeedleTool].wanted_N.z, -1.5 * 0.5, 0.01);
  held.hold({-80, 0, -20}, {0, 0, 8}, 400);
  EXPECT_LT(norm(held.out.tools[kNeedleTool].wanted_N), 0.01);
  held.setup.needleFixed = false;
  held.servo.configure(held.setup);
  held.hold({-80, 0, -20}, {0, 0, -20}, 600);
  EXPECT_FALSE(held.out.needle.inBody) << "and can be drawn out";
}

/// The hand leaves the needle, grips a wire, and feels where the wire has stopped.
TEST(Servo, AFreeHandGripsAWireAndFeelsItsStop) {
  Held held;
  held.hold({-80, 0, -20}, {0, 0, 8}, 400);
  const Transform tool = held.out.tools[kNeedleTool].patientFromTool;
  held.setup.needleFixed = true, held.setup.freeHand = FreeHand::Free;
  held.servo.configure(held.setup);
  held.hold({-80, 0, -20}, {0, 0, 8}, 1);
  held.hold({-80, 0, -20}, {0, 0, 20}, 400);
  EXPECT_LT(norm(held.out.tools[kNeedleTool].wanted_N), 1e-9);
  held.setup.freeHand = FreeHand::AtWire;
  held.servo.configure(held.setup);
  held.hold({-80, 0, -20}, {0, 0, 20}, 1);
  EXPECT_EQ(held.out.wireHand_mm, 0) << "counted from the grip";
  held.hold({-80, 0, -20}, {1, 0, 22}, 400);
  const Vec3 axis = tool.linear.column[2];
  EXPECT_NEAR(held.out.wireHand_mm, dot(Vec3{1, 0, 2}, axis), 1e-6);
  // Half of what the device can show, 3 N/mm, along the needle alone.
  EXPECT_NEAR(dot(held.out.tools[kNeedleTool].wanted_N, axis), -1.5 * held.out.wireHand_mm, 0.01);
  held.setup.wire = {.gone_mm = held.out.wireHand_mm, .resistance_N = 0.5};
  held.servo.configure(held.setup);
  held.hold({-80, 0, -20}, {1, 0, 22}, 400);
  EXPECT_NEAR(dot(held.out.tools[kNeedleTool].wanted_N, axis), -0.5, 0.01) << "the wire followed, with a resistance";
  EXPECT_LT(norm(cross(held.out.tools[kNeedleTool].wanted_N, axis)), 0.01);
  EXPECT_LT(norm(held.out.tools[kNeedleTool].patientFromTool.offset - tool.offset), 1e-3) << "the needle stays";
}

TEST(Servo, AHeldNeedleThatIsUnpluggedIsHeldNoMore) {
  Held held;
  held.hold({-80, 0, -20}, {0, 0, 8}, 400);
  held.setup.needleFixed = true;
  held.servo.configure(held.setup);
  held.hold({-80, 0, -20}, {0, 0, 8}, 10);
  held.present[kNeedleTool] = false;
  held.hold({-80, 0, -20}, {0, 0, -20}, 400);
  held.present[kNeedleTool] = true;
  held.hold({-80, 0, -20}, {0, 0, -20}, 10);
  EXPECT_NEAR(held.out.tools[kNeedleTool].patientFromTool.offset.z, -20, 0.1) << "where it was taken up again";
  EXPECT_LT(norm(held.out.tools[kNeedleTool].force.force_N), 1e-6);
}

/// Another place of the tool is no way of the hand: no energy comes of it.
TEST(Servo, ANewMappingInContactGivesTheHandNoEnergy) {
  for (const double shift_mm : {-30.0, 30.0}) {
    Held held;
    held.hold({-80, 0, 5}, {0, 0, -20}, 400);
    ASSERT_GT(held.out.tools[kProbeTool].energy_J, 0);
    held.setup.tools[kProbeTool].patientFromDevice.offset = {0, 0, shift_mm};
    held.servo.configure(held.setup);
    held.hold({-80, 0, 5}, {0, 0, -20}, 1);
    EXPECT_LE(held.out.tools[kProbeTool].energy_J, 1e-6) << shift_mm;
  }
}

TEST(Servo, ATickAllocatesNothing) {
  LoopRig rig(deviceProfiles()[0].limits, layerOf(kMuscle));
  RandomHand probe(1, {-30, -5, -15}, {0, 5, 12}), needle(2, {-12, -4, -12}, {12, 4, 40});
  ServoInput input{.now_ns = 2'000'000'000, .tools = {}, .present = {true, true}};
  rig.setup.needle.name = "a name so long that copying it would have to allocate";
  rig.servo.configure(rig.setup);
  rig.servo.setLocalModel(modelOf(rig.grid, 2'000'000'000));
  const long before = test::allocations();
  for (int i = 0; i < 20000; ++i) {
    input.now_ns += 1'000'000;
    const auto a = probe.next(), b = needle.next();
    input.tools[0] = {.deviceFromStylus = {a.attitude, a.position_mm},
                      .velocity_mmps = {},
                      .angularVelocity_radps = {},
                      .buttons = 0,
                      .time_ns = input.now_ns};
    input.tools[1] = {.deviceFromStylus = {b.attitude, b.position_mm},
                      .velocity_mmps = {},
                      .angularVelocity_radps = {},
                      .buttons = 0,
                      .time_ns = input.now_ns};
    rig.servo.tick(input);
  }
  EXPECT_EQ(test::allocations(), before);
}

TEST(Servo, WhatIsNotFiniteDoesNoHarm) {
  Held held;
  held.hold({-80, 0, 5}, {0, 0, 5}, 300);
  ServoInput input{.now_ns = held.time_ns + 1'000'000, .tools = {}, .present = {true, true}};
  for (DeviceState& state : input.tools) {
    state.deviceFromStylus.offset = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
    state.time_ns = input.now_ns;
  }
  const ServoOutput out = held.servo.tick(input);
  for (const ToolOutput& hand : out.tools) EXPECT_EQ(norm(hand.force.force_N), 0);
  EXPECT_TRUE(std::isfinite(norm(held.hold({-80, 0, 5}, {0, 0, 5}, 300).tools[0].force.force_N)));
}

/// Unplugged while it presses hard, on bone, in the loop: zero force, and back without a kick.
TEST(Servo, UnpluggedInContact) {
  for (const DeviceProfile& profile : deviceProfiles()) {
    LoopRig rig(profile.limits, layerOf(kMuscle));
    for (int i = 0; i < 4000; ++i) rig.tick({0, {-80, 0, 8}, {}}, {0, {0, 0, std::min(-20 + i * 0.02, 45.0)}, {}});
    EXPECT_GT(norm(rig.out.tools[kNeedleTool].force.force_N), 0.5) << profile.name;
    rig.present = {false, false};
    rig.tick({0, {-80, 0, 8}, {}}, {0, {0, 0, 45}, {}});
    for (const ToolOutput& hand : rig.out.tools) EXPECT_EQ(norm(hand.force.force_N), 0) << profile.name;
    for (int i = 0; i < 200; ++i) rig.tick({0, {-80, 0, 8}, {}}, {0, {0, 0, 45}, {}});
    rig.present = {true, true};
    rig.tick({0, {-80, 0, 8}, {}}, {0, {0, 0, 45}, {}});
    for (const ToolOutput& hand : rig.out.tools) EXPECT_LE(norm(hand.force.force_N), 0.5) << profile.name;
  }
}

}  // namespace
}  // namespace insonate::haptics
