#include "needle/NeedleMechanics.h"
#include "servo/EnergyTank.h"

#include <insonate/haptics/HapticMeasurements.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kTick_s = 0.001;
constexpr int kKnockTicks = 5;

TissueSample layerAt(Vec3 p) {
  TissueSample sample;
  sample.distance_mm = {float(-p.z), float(std::abs(p.z - 23) - 5), 100, 100, float(40 - p.z), 100};
  sample.label = p.z < 0    ? kBackground
                 : p.z < 2  ? kSkin
                 : p.z < 10 ? kFat
                 : p.z < 18 ? kMuscle
                 : p.z < 28 ? kVein
                 : p.z < 40 ? kMuscle
                            : kBone;
  return sample;
}

bool comesToRest(DeviceLimits device, const Grip& grip, bool account, double stiffness_Npmm) {
  device.maxForce_N = 1e9;  // no limit, which would keep all oscillations small
  SimulatedHand hand(device, grip, {});
  haptics::EnergyTank tank;
  tank.setLimits({.max_J = 1,
                  .friction_N = device.friction_N,
                  .damping_Nspmm = device.damping_Nspm * 1e-3,
                  .resolution_mm = device.resolution_mm,
                  .mass_kg = std::max(device.mass_kg, 0.03)});
  const double left_mm = 0.25 * device.resolution_mm;
  double first_mm = 0, last_mm = 0;  // maximum speed, mm a tick
  // A push of 5 ms that gives a speed of 50 mm/s.
  const Vec3 knock_N{(device.mass_kg + grip.mass_kg) * 0.05 / (kKnockTicks * kTick_s), 0, 0};
  for (int tick = 0; tick < 2000; ++tick) {
    const Vec3 at = hand.state(0).deviceFromStylus.offset;
    Force force{at * -stiffness_Npmm, {}};
    if (account) force = tank.pass(force, {}, {at, {}, {}}, kTick_s);
    if (tick < kKnockTicks) force.force_N = force.force_N + knock_N;
    hand.move({}, force, kTick_s);
    if (!(norm(hand.position_mm()) < 100)) return false;
    const double way_mm = norm(hand.velocity_mmps()) * kTick_s;
    if (tick < 700 && tick >= kKnockTicks) first_mm = std::max(first_mm, way_mm);
    if (tick >= 1300) last_mm = std::max(last_mm, way_mm);
  }
  return last_mm < std::max(left_mm, first_mm);
}

}  // namespace

std::shared_ptr<const TissueGrid> layeredPhantom() {
  VolumeGeometry grid;
  grid.size = {9, 9, 161};
  grid.spacing_mm = {4, 4, 0.5};
  grid.origin_mm = {-16, -16, -20};
  return *TissueGrid::make(grid, layerAt);
}

std::vector<ForceDepthPoint> needleForceCurve(const NeedleTable& table, double speed_mmps, double steepest_Npmm,
                                              double deepest_mm) {
  const auto grid = layeredPhantom();
  haptics::NeedleMechanics needle;
  needle.configure(table, steepest_Npmm);
  std::vector<ForceDepthPoint> curve;
  haptics::NeedleEvents events;
  const double step_mm = speed_mmps * kTick_s, way_mm = deepest_mm + 3;
  const auto ticks = static_cast<std::int64_t>(2 * way_mm / step_mm);
  for (std::int64_t i = 0; i <= ticks; ++i) {
    const double gone_mm = static_cast<double>(i) * step_mm;
    const double z = gone_mm < way_mm ? gone_mm - 3 : deepest_mm - (gone_mm - way_mm);
    needle.move(*grid, {}, {0, 0, z}, {0, 0, 1}, kTick_s, i * 1'000'000, events);
    curve.push_back({z, needle.state().axial_N, needle.state().in});
  }
  return curve;
}

double maxStableStiffness_Npmm(const DeviceLimits& device, const Grip& grip, bool account) {
  double stable = 0;
  for (double k = 0.01; k <= 20; k *= 1.07) {
    if (!comesToRest(device, grip, account, k)) break;
    stable = k;
  }
  return stable;
}

}  // namespace insonate
