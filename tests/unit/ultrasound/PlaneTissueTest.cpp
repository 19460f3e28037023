#include "support/LabelPhantom.h"

#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ultrasound/PlaneTissue.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace insonate::test {
namespace {

constexpr double kVoxel_mm = 0.7;

double toBall(Vec3 p, Vec3 center, double radius_mm) {
  return norm(p - center) - radius_mm;
}
double toVein(Vec3 p) {
  return toBall(p, {-8, 1, 20}, 6);
}
double toArtery(Vec3 p) {
  return toBall(p, {8, 2, 17}, 4.5);
}
/// Outside the box that is bone: exact but near its edges.
double toBone(Vec3 p) {
  const Vec3 off{std::abs(p.x) - 14, std::abs(p.y) - 9, std::abs(p.z - 38) - 6};
  const Vec3 beyond{std::max(off.x, 0.0), std::max(off.y, 0.0), std::max(off.z, 0.0)};
  return norm(beyond) + std::min(std::max({off.x, off.y, off.z}), 0.0);
}
double toSkin(Vec3 p) {
  return 3.5 - p.z;  // the body lies below
}
int labelAt(Vec3 p) {
  if (toSkin(p) > 0) return kBackground;
  if (toVein(p) < 0) return kVein;
  if (toArtery(p) < 0) return kArtery;
  return toBone(p) < 0 ? kBone : kMuscle;
}
/// A distance out of reach reads as up to half a voxel less.
double cut(double mm) {
  const double reach_mm = kPlaneReach_mm - kVoxel_mm / 2;
  return std::clamp(mm, -reach_mm, reach_mm);
}

/// Near a structure's outline; elsewhere distances know the voxels alone, and their ridges are rounded.
double allowed(double mm) {
  return std::abs(mm) < 1.5 ? 0.25 : 0.8;
}

class PlaneTissueOf : public testing::Test {
 protected:
  const LabelPhantom phantom = paint(gridOver({-28, -14, -7}, {28, 14, 56}, kVoxel_mm), labelAt);

  std::shared_ptr<const AcousticScene> sceneOf(const LabelPhantom& of) {
    return *AcousticScene::make(of.ct, of.labels, AcousticTable{}, {{-40, -40, -40}, {40, 40, 80}});
  }
};

/// The plane is turned and moved in the patient.
Transform tilted() {
  const double c = std::cos(0.3), s = std::sin(0.3);
  return {{{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, 1}}}, {0.4, 0.7, 1.1}};
}

std::vector<PlanePoint> gridOfPoints(double step_mm) {
  std::vector<PlanePoint> points;
  for (double z = -2; z < 48; z += step_mm)
    for (double x = -22; x < 22; x += step_mm) points.push_back({static_cast<float>(x), static_cast<float>(z)});
  return points;
}

TEST_F(PlaneTissueOf, AKnownBodyHasItsLabelsAndDistances) {
  const Transform pose = tilted();
  const std::vector<PlanePoint> points = gridOfPoints(0.37);
  PlaneSamples tissue;
  samplePlane(*sceneOf(phantom), pose, points, tissue);
  ASSERT_EQ(tissue.label.size(), points.size());
  int seen[kLabelCount]{};
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Vec3 p = pose * Vec3{points[n].x_mm, 0, points[n].z_mm};
    const double artery = toArtery(p), vein = toVein(p), bone = toBone(p), skin = toSkin(p);
    EXPECT_NEAR(tissue.toArtery_mm[n], cut(artery), allowed(artery)) << p.x << ", " << p.y << ", " << p.z;
    EXPECT_NEAR(tissue.toVein_mm[n], cut(vein), allowed(vein)) << p.x << ", " << p.y << ", " << p.z;
    EXPECT_NEAR(tissue.toSkin_mm[n], cut(skin), allowed(skin)) << p.x << ", " << p.y << ", " << p.z;
    EXPECT_NEAR(tissue.toBone_mm[n], cut(bone), 0.8) << p.x << ", " << p.y << ", " << p.z;  // edges are rounded
    const double nearest = std::min({std::abs(artery), std::abs(vein), std::abs(bone), std::abs(skin)});
    if (nearest > 0.6) {
      EXPECT_EQ(tissue.label[n], labelAt(p)) << p.x << ", " << p.y << ", " << p.z;
      ++seen[tissue.label[n]];
    }
  }
  for (const Label label : {kBackground, kVein, kArtery, kBone, kMuscle}) EXPECT_GT(seen[label], 50) << int(label);
}

TEST_F(PlaneTissueOf, LabelsAreThoseOfTheLabelMap) {
  const std::vector<PlanePoint> points = gridOfPoints(0.7);
  PlaneSamples tissue;
  samplePlane(*sceneOf(phantom), {}, points, tissue);
  const VolumeGeometry& grid = phantom.labels.geometry;
  int same = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Vec3 v = grid.indexFromPatient() * Vec3{points[n].x_mm, 0, points[n].z_mm};
    const auto at = [&](int a) { return static_cast<int>(std::lround(v[a])); };
    same += tissue.label[n] == phantom.labels.at(at(0), at(1), at(2));
  }
  EXPECT_GT(same, 0.97 * double(points.size()));
}

TEST_F(PlaneTissueOf, BatchesOfAnySizeAgree) {
  const auto scene = sceneOf(phantom);
  const std::vector<PlanePoint> points = gridOfPoints(1.7);
  PlaneSamples all, some;
  samplePlane(*scene, tilted(), points, all);
  for (const std::size_t count : {1, 7, 31, 32, 33, 100})
    for (std::size_t first = 0; first + count <= points.size(); first += 171) {
      samplePlane(*scene, tilted(), std::span(points).subspan(first, count), some);
      ASSERT_EQ(some.toVein_mm.size(), count);
      for (std::size_t n = 0; n < count; ++n) {
        EXPECT_EQ(some.label[n], all.label[first + n]);
        EXPECT_EQ(some.toVein_mm[n], all.toVein_mm[first + n]);
        EXPECT_EQ(some.toSkin_mm[n], all.toSkin_mm[first + n]);
      }
    }
  samplePlane(*scene, tilted(), {}, some);
  EXPECT_TRUE(some.label.empty());
}

TEST_F(PlaneTissueOf, PointsOutsideReadAsTheOutermostWithin) {
  PlaneSamples tissue;
  const std::vector<PlanePoint> points{{0, -500}, {0, -6.9F}, {500, 15}, {27.9F, 15}, {1e6F, 1e6F}};
  samplePlane(*sceneOf(phantom), {}, points, tissue);
  EXPECT_EQ(tissue.label[0], kBackground);
  EXPECT_EQ(tissue.toSkin_mm[0], tissue.toSkin_mm[1]);
  EXPECT_EQ(tissue.label[2], kMuscle);
  EXPECT_EQ(tissue.toSkin_mm[2], tissue.toSkin_mm[3]);
  EXPECT_EQ(tissue.label[4], kMuscle);
}

TEST_F(PlaneTissueOf, WhatTheSceneHasNotIsOutOfReach) {
  PlaneSamples tissue;
  const std::vector<PlanePoint> points{{0, 10}, {3, 20}};
  samplePlane(*sceneOf(paint(phantom.labels.geometry, [](Vec3) { return kMuscle; })), {}, points, tissue);
  for (int n = 0; n < 2; ++n) {
    EXPECT_EQ(tissue.label[n], kMuscle);
    EXPECT_EQ(tissue.toArtery_mm[n], kPlaneReach_mm);
    EXPECT_EQ(tissue.toVein_mm[n], kPlaneReach_mm);
    EXPECT_EQ(tissue.toBone_mm[n], kPlaneReach_mm);
    EXPECT_EQ(tissue.toSkin_mm[n], -kPlaneReach_mm) << "all of it is body";
  }
}

}  // namespace
}  // namespace insonate::test
