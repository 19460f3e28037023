#pragma once

#include "NeedleRig.h"

#include <insonate/haptics/HapticServo.h>
#include <insonate/haptics/SimulatedHand.h>

#include <algorithm>
#include <random>

namespace insonate::haptics {

/// Tissue of one label under skin, with a vein in it and bone below, so that all that a needle can meet is there.
inline std::shared_ptr<const TissueGrid> layerOf(Label filling) {
  Block block;
  block.veinDepth_mm = 14;
  block.bone_mm = 30;
  VolumeGeometry g;
  g.size = {61, 21, 61};
  g.origin_mm = {-30, -10, -20};
  return *TissueGrid::make(g, [=](Vec3 p) {
    TissueSample sample = block.at(p);
    if (sample.label == kFat || sample.label == kMuscle) sample.label = filling;
    return sample;
  });
}

/// A flat skin at z = 0, three points of a linear probe's face.
inline LocalModel modelOf(std::shared_ptr<const TissueGrid> grid, std::int64_t time_ns) {
  LocalModel model;
  model.time_ns = time_ns;
  model.grid = std::move(grid);
  model.patchCount = 3;
  for (int i = 0; i < 3; ++i) model.patches[i] = {{(i - 1) * 15.0, 0, 0}, {}, {0, 0, -1}, 0.1, 0.01};
  return model;
}

/// Both hands in one kind of device, device frame and patient frame the same but for an offset; the servo between them.
struct LoopRig {
  LoopRig(const DeviceLimits& device, std::shared_ptr<const TissueGrid> tissue, Vec3 probeAt = {-80, 0, -30},
          Vec3 needleAt = {0, 0, -30}, const Grip& grip = {}, const char* table = "measured")
      : grid(std::move(tissue)), hands{SimulatedHand(device, grip, probeAt), SimulatedHand(device, grip, needleAt)} {
    for (ToolSetup& hand : setup.tools) hand.limits = device;
    setup.needle = *loadNeedleTable(table);
    servo.configure(setup);
    servo.setLocalModel(modelOf(grid, time_ns));
  }

  ServoOutput tick(const HandPath::Point& probe, const HandPath::Point& needle) {
    time_ns += 1'000'000;
    if (ticks % 30 == 0 && shows) servo.setLocalModel(modelOf(grid, time_ns));
    ++ticks;
    ServoInput input{time_ns, {hands[0].state(time_ns), hands[1].state(time_ns)}, present};
    out = servo.tick(input);
    for (int i = 0; i < out.eventCount; ++i) events.push_back(out.events[i]);
    const std::array<HandPath::Point, 2> want{probe, needle};
    for (int h = 0; h < 2; ++h) {
      hands[h].move(want[h], out.tools[h].force, 0.001);
      observers[h].add(hands[h].intoLoop_J() + hands[h].lost_J(), norm(out.tools[h].force.force_N) > 0);
    }
    return out;
  }

  std::shared_ptr<const TissueGrid> grid;
  std::array<SimulatedHand, 2> hands;
  std::array<PassivityObserver, 2> observers;
  std::array<bool, 2> present{true, true};
  bool shows = true;
  ServoSetup setup;
  HapticServo servo;
  ServoOutput out;
  std::vector<NeedleEvent> events;
  std::int64_t time_ns = 1'000'000'000, ticks = 0;
};

/// A hand that wants something else every now and then, as fast as hands are: in, out, sideways, and now and then a
/// jerk.
struct RandomHand {
  explicit RandomHand(unsigned seed, Vec3 low, Vec3 high) : random(seed), low_mm(low), high_mm(high) {}

  HandPath::Point next() {
    if (--left <= 0) {
      const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
      goal_mm = {between(low_mm.x, high_mm.x), between(low_mm.y, high_mm.y), between(low_mm.z, high_mm.z)};
      tilt = {between(-0.3, 0.3), between(-0.3, 0.3), 1};
      left = static_cast<int>(between(50, 1500));
      const double fastest = between(0, 1) < 0.1 ? 1.0 : 0.15;  // mm a tick: m/s
      step_mm = between(0.005, fastest);
    }
    const Vec3 way = goal_mm - at_mm;
    const double length = norm(way);
    at_mm = length > step_mm ? at_mm + way * (step_mm / length) : goal_mm;
    axis = normalized(axis + (normalized(tilt) - axis) * 0.003);
    const Vec3 x = normalized(cross(Vec3{0, 1, 0}, axis));
    return {0, at_mm, {{x, cross(axis, x), axis}}};
  }

  std::mt19937 random;
  Vec3 low_mm, high_mm, at_mm{0, 0, -30}, goal_mm, tilt{0, 0, 1}, axis{0, 0, 1};
  int left = 0;
  double step_mm = 0.1;
};

}  // namespace insonate::haptics
