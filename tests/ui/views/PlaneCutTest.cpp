#include "Neck.h"
#include "scene/PlaneCut.h"
#include "ui/support/Screen.h"

#include <insonate/surface/ExtractSurface.h>
#include <insonate/tissue/Labels.h>
#include <insonate/views/LabelColors.h>
#include <insonate/views/SceneView.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate::views {
namespace {

struct Shape {
  std::vector<float> points;
  std::vector<std::uint32_t> triangles;
  operator Surface() const { return {points, {}, triangles}; }
};

/// A ball about the origin, added to a shape; turned inside out where it is a hollow.
void addBall(Shape& shape, double radius_mm) {
  constexpr int kAround = 96, kDown = 64;
  const auto base = std::uint32_t(shape.points.size() / 3);
  for (int down = 0; down <= kDown; ++down)
    for (int around = 0; around < kAround; ++around) {
      const double theta = std::numbers::pi * down / kDown, phi = 2 * std::numbers::pi * around / kAround;
      for (const double value : {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)})
        shape.points.push_back(float(radius_mm * value));
    }
  for (int down = 0; down < kDown; ++down)
    for (int around = 0; around < kAround; ++around) {
      const auto at = [&](int row, int column) { return base + std::uint32_t(row * kAround + column % kAround); };
      for (const std::uint32_t corner : {at(down, around), at(down + 1, around), at(down + 1, around + 1),
                                         at(down, around), at(down + 1, around + 1), at(down, around + 1)})
        shape.triangles.push_back(corner);
    }
}

Vec3 pointOf(const PlaneCut& cut, std::uint32_t k) {
  const float* at = cut.points_mm().data() + 3 * std::size_t(k);
  return {at[0], at[1], at[2]};
}

double area_mm2(const PlaneCut& cut) {
  double sum = 0;
  for (std::size_t k = 0; k < cut.triangles().size(); k += 3) {
    const Vec3 a = pointOf(cut, cut.triangles()[k]);
    sum += norm(cross(pointOf(cut, cut.triangles()[k + 1]) - a, pointOf(cut, cut.triangles()[k + 2]) - a)) / 2;
  }
  return sum;
}

double length_mm(const PlaneCut& cut) {
  double sum = 0;
  for (std::size_t k = 0; k < cut.outline().size(); k += 2)
    sum += norm(pointOf(cut, cut.outline()[k]) - pointOf(cut, cut.outline()[k + 1]));
  return sum;
}

TEST(PlaneCut, ABallIsCutAlongACircle) {
  Shape ball;
  addBall(ball, 20);
  PlaneCut cut;
  for (const Vec3 normal : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0.3, -0.8, 0.52}})
    for (const double distance_mm : {0.4, -12.3, 16.2}) {
      const Vec3 n = normalized(normal);
      cut.cut(ball, {n * distance_mm, n});
      const double radius_mm = std::sqrt(400 - distance_mm * distance_mm);
      EXPECT_NEAR(area_mm2(cut), std::numbers::pi * radius_mm * radius_mm, 0.01 * 400 * std::numbers::pi);
      EXPECT_NEAR(length_mm(cut), 2 * std::numbers::pi * radius_mm, 0.01 * 40 * std::numbers::pi);
      for (std::uint32_t k = 0; k < cut.points_mm().size() / 3; ++k) {
        EXPECT_NEAR(dot(pointOf(cut, k), n), distance_mm, 1e-4);
        EXPECT_LT(norm(pointOf(cut, k)), 20.2);
      }
    }
  cut.cut(ball, {{0, 0, 21}, {0, 0, 1}});
  EXPECT_TRUE(cut.triangles().empty() && cut.outline().empty()) << "beside it there is nothing";
}

TEST(PlaneCut, WhatIsHollowStaysHollow) {
  Shape shell;
  addBall(shell, 20);
  addBall(shell, 15);
  PlaneCut cut;
  cut.cut(shell, {{0, 0, 1}, {0, 0, 1}});
  EXPECT_NEAR(area_mm2(cut), std::numbers::pi * (400 - 225), 8);
  EXPECT_NEAR(length_mm(cut), 2 * std::numbers::pi * (std::sqrt(399) + std::sqrt(224)), 2);
}

TEST(PlaneCut, AHoleInASurfaceIsNotSpreadOverThePicture) {
  Shape ball;
  addBall(ball, 20);
  ball.triangles.erase(ball.triangles.begin() + 6 * 96 * 30, ball.triangles.begin() + 6 * 96 * 30 + 30);
  PlaneCut cut;
  cut.cut(ball, {{0, 0, 0.9}, {0, 0, 1}});
  EXPECT_LT(area_mm2(cut), 1.01 * std::numbers::pi * 400);
  for (std::uint32_t k = 0; k < cut.points_mm().size() / 3; ++k) EXPECT_LT(norm(pointOf(cut, k)), 20.2);
}

/// The neck from above, cut across: the middle of the vein has the vein's color, whatever its wall looks like inside.
TEST(CutScene, ACutVesselShowsItsInside) {
  const PatientCase& patient = *test::neck().patient;
  SceneView view;
  view.setCase(test::neck().shown);
  const Mesh vein = extractSurface(patient.labels, kVein, {4, 1}).value();
  const Mesh body = extractBody(patient.labels, {8, 3}).value();
  view.setSurface(kVein, {vein.points_mm, vein.normals, vein.triangles});
  view.setSurface(kSkin, {body.points_mm, body.normals, body.triangles});
  test::Screen screen(view, 400, 360);
  view.setViewpoint(Viewpoint::Superior);
  // The middle of the widest vein in a slice.
  const int k = patient.labels.geometry.size[2] / 2;
  Vec3 sum;
  int count = 0;
  const VolumeGeometry& grid = patient.labels.geometry;
  for (int j = 0; j < grid.size[1]; ++j)
    for (int i = 0; i < grid.size[0] / 2; ++i)
      if (patient.labels.at(i, j, k) == kVein && std::abs(i - grid.size[0] / 4) < grid.size[0] / 8)
        sum = sum + Vec3{double(i), double(j), double(k)}, ++count;
  ASSERT_GT(count, 20);
  const Vec3 inside_mm = grid.patientFromIndex() * (sum / count);
  ASSERT_EQ(sampleNearest(patient.labels, sum / count), kVein);
  const double offset_mm = inside_mm.z - grid.center_mm().z;
  const auto colorAt = [&] {
    const DisplayPoint at = view.displayFromPatient(inside_mm);
    const std::uint8_t* seen = screen.picture().at(int(at.x), int(at.y));
    return std::array{int(seen[0]), int(seen[1]), int(seen[2])};
  };
  const auto like = [](std::array<int, 3> seen, Color wanted) {
    return std::abs(seen[0] - 0.92 * wanted.red) < 5 && std::abs(seen[1] - 0.92 * wanted.green) < 5 &&
           std::abs(seen[2] - 0.92 * wanted.blue) < 5;
  };
  view.setClipping({ClippingKind::Axial, offset_mm, true});
  EXPECT_TRUE(like(colorAt(), view.color(kVein)));
  view.setMoving(true);
  EXPECT_TRUE(like(colorAt(), view.color(kVein))) << "while it is dragged, too";
  view.setMoving(false);
  view.setColor(kVein, {200, 30, 220});
  EXPECT_TRUE(like(colorAt(), {200, 30, 220}));
  view.setSkinOpacity(1);
  EXPECT_TRUE(like(colorAt(), {200, 30, 220})) << "before the body it lies in";
  view.setVisible(kVein, false);
  EXPECT_TRUE(like(colorAt(), view.color(kSkin)));
  view.setVisible(kVein, true);
  view.setOpacity(kVein, 0.5);
  view.setSkinOpacity(0.25);
  EXPECT_FALSE(like(colorAt(), {200, 30, 220})) << "one looks into what is translucent";
  view.setOpacity(kVein, 1);
  view.setClipping({});
  EXPECT_FALSE(like(colorAt(), {200, 30, 220}));
}

}  // namespace
}  // namespace insonate::views
