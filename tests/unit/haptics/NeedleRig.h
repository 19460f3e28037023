#pragma once

#include "needle/NeedleMechanics.h"

#include <insonate/haptics/TissueGrid.h>
#include <insonate/tissue/NeedleTable.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace insonate::haptics {

/// A block of tissue below z = 0 (its skin): 2 mm of skin, fat to 8 mm, muscle, bone from 60 mm. Vein and artery are
/// tubes along y, the vein 20 mm deep at x = 0, the artery beside it. z grows into the body.
struct Block {
  double veinDepth_mm = 20, veinRadius_mm = 5;
  double arteryX_mm = 15, arteryRadius_mm = 3;
  double bone_mm = 60;

  TissueSample at(Vec3 p) const {
    TissueSample sample;
    const auto tube = [&](double x, double radius) { return std::hypot(p.x - x, p.z - veinDepth_mm) - radius; };
    const double vein = tube(0, veinRadius_mm), artery = tube(arteryX_mm, arteryRadius_mm);
    sample.distance_mm = {float(-p.z), float(vein), float(artery), 100, float(bone_mm - p.z), 100};
    sample.label = vein < 0        ? kVein
                   : artery < 0    ? kArtery
                   : p.z > bone_mm ? kBone
                   : p.z < 0       ? kBackground
                   : p.z < 2       ? kSkin
                   : p.z < 8       ? kFat
                                   : kMuscle;
    return sample;
  }
  std::shared_ptr<const TissueGrid> grid() const {
    VolumeGeometry g;
    g.size = {61, 21, 91};
    g.origin_mm = {-30, -10, -20};
    return *TissueGrid::make(g, [this](Vec3 p) { return at(p); });
  }
};

/// A needle moved by hand, a millisecond at a time.
struct NeedleRig {
  explicit NeedleRig(const Block& block = {}, double steepest_Npmm = 1) : grid(block.grid()) {
    needle.configure(*loadNeedleTable("measured"), steepest_Npmm);
  }

  NeedleForce put(Vec3 tip, Vec3 axis) {
    NeedleEvents fresh;
    time_ns += 1'000'000;
    const NeedleForce force = needle.move(*grid, {}, tip, normalized(axis), 0.001, time_ns, fresh);
    keep(fresh);
    at = tip;
    return force;
  }
  void remove() {
    NeedleEvents fresh;
    needle.remove(time_ns += 1'000'000, fresh);
    keep(fresh);
  }
  void keep(const NeedleEvents& fresh) {
    events.insert(events.end(), fresh.list.begin(), fresh.list.begin() + fresh.count);
    lost += fresh.lost;
  }
  /// Straight to `to` in steps of `speed_mmps` for a millisecond; returns the largest resistance along the axis.
  double push(Vec3 to, Vec3 axis, double speed_mmps) {
    const Vec3 from = at;
    const int steps = std::max(1, int(std::ceil(norm(to - from) / (speed_mmps * 0.001))));
    double max_N = 0;
    for (int i = 1; i <= steps; ++i) {
      put(from + (to - from) * (double(i) / steps), axis);
      max_N = std::max(max_N, needle.state().axial_N);
    }
    return max_N;
  }
  int count(NeedleEventKind kind, Label wall) const {
    int n = 0;
    for (const NeedleEvent& e : events) n += e.kind == kind && e.wall == wall;
    return n;
  }

  std::shared_ptr<const TissueGrid> grid;
  NeedleMechanics needle;
  std::vector<NeedleEvent> events;
  std::int64_t time_ns = 0;
  int lost = 0;
  Vec3 at{0, 0, -10};
};

}  // namespace insonate::haptics
