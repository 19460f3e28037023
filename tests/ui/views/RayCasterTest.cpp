#include "cast/CastProp.h"
#include "cast/RayCaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace insonate::views {
namespace {

constexpr double kReach_mm = 40;

/// Looks along +z through a cube of 80 mm about the origin, square to it, from z = -40.
CastView straightView(int width, int height) {
  CastView view;
  view.patientFromSeen = {kReach_mm, 0, 0, 0, 0, kReach_mm, 0, 0, 0, 0, kReach_mm, 0, 0, 0, 0, 1};
  view.patientFromCamera = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}};
  view.width = width, view.height = height;
  view.depth.assign(std::size_t(width) * height, 1);
  return view;
}

VolumeGeometry cube(int size, double spacing_mm) {
  VolumeGeometry grid;
  grid.size = {size, size, size};
  grid.spacing_mm = {spacing_mm, spacing_mm, spacing_mm};
  const double first_mm = -spacing_mm * (size - 1) / 2;
  grid.origin_mm = {first_mm, first_mm, first_mm};
  return grid;
}

std::shared_ptr<const CastLook> look(const CtVolume& ct, const TransferFunction& function) {
  auto patient = std::make_shared<PatientCase>(PatientCase{{}, ct, LabelMap(ct.geometry)});
  return std::make_shared<const CastLook>(makeCastVolume(std::move(patient)), function);
}

/// Clear below 0 HU, and 2 % of a millimeter's light kept from 100 HU on.
TransferFunction haze() {
  return {{{0, 0, {255, 255, 255}}, {1, 0.02, {255, 255, 255}}, {3071, 0.02, {255, 255, 255}}}};
}

std::vector<std::uint8_t> cast(const std::shared_ptr<const CastLook>& shown, const CastView& view,
                               bool coarse = false) {
  std::vector<std::uint8_t> rgba;
  castAll({shown, view, view.width, view.height, coarse}, rgba);
  return rgba;
}

int opacityAt(const std::vector<std::uint8_t>& rgba, const CastView& view, int x, int y) {
  return rgba[4 * (std::size_t(y) * view.width + x) + 3];
}

/// A block of 20 mm in the middle of air.
CtVolume block() {
  CtVolume ct(cube(64, 1), -1000);
  for (int k = 22; k < 42; ++k)
    for (int j = 22; j < 42; ++j)
      for (int i = 22; i < 42; ++i) ct.at(i, j, k) = 500;
  return ct;
}

TEST(RayCaster, OpacityGrowsWithTheWayThroughTissue) {
  const auto shown = look(block(), haze());
  const CastView view = straightView(40, 40);
  for (const bool coarse : {false, true}) {
    const auto rgba = cast(shown, view, coarse);
    EXPECT_NEAR(opacityAt(rgba, view, 20, 20), 255 * (1 - std::pow(0.98, 20)), 4) << coarse;
    EXPECT_EQ(opacityAt(rgba, view, 3, 3), 0);
    EXPECT_EQ(opacityAt(rgba, view, 20, 34), 0);
  }
}

TEST(RayCaster, WhatIsDrawnAlreadyEndsARay) {
  const auto shown = look(block(), haze());
  CastView view = straightView(40, 40);
  std::fill(view.depth.begin(), view.depth.begin() + 20 * 40, 0.5F);  // at z = 0, for the lower half
  const auto rgba = cast(shown, view);
  EXPECT_NEAR(opacityAt(rgba, view, 20, 18), 255 * (1 - std::pow(0.98, 10)), 4);
  EXPECT_NEAR(opacityAt(rgba, view, 20, 22), 255 * (1 - std::pow(0.98, 20)), 4);
}

TEST(RayCaster, OneSideOfAClippingPlaneIsLeftOut) {
  const auto shown = look(block(), haze());
  CastView view = straightView(40, 40);
  view.clipping = ClippingPlane{{0, 0, 5}, {0, 0, 1}};
  EXPECT_NEAR(opacityAt(cast(shown, view), view, 20, 20), 255 * (1 - std::pow(0.98, 5)), 4);
  view.clipping = ClippingPlane{{0, 0, 5}, {0, 0, -1}};
  EXPECT_NEAR(opacityAt(cast(shown, view), view, 20, 20), 255 * (1 - std::pow(0.98, 15)), 4);
  view.clipping = ClippingPlane{{0, 0, 5}, {1, 0, 0}};
  const auto rgba = cast(shown, view);
  EXPECT_EQ(opacityAt(rgba, view, 18, 20), 0);
  EXPECT_NEAR(opacityAt(rgba, view, 22, 20), 255 * (1 - std::pow(0.98, 20)), 4);
}

TEST(RayCaster, ObliqueAndLeftHandedGridsLieWhereTheyLie) {
  VolumeGeometry grid = cube(24, 2);
  const double c = std::cos(0.5), s = std::sin(0.5);
  grid.direction = {{{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, -1}}}};
  grid.spacing_mm = {2, 2.5, 3};
  grid.origin_mm = {-8, -31, 30};
  CtVolume ct(grid, -1000);
  ct.at(5, 18, 9) = 2000;
  const Vec3 at_mm = grid.patientFromIndex() * Vec3{5, 18, 9};
  const CastView view = straightView(200, 200);
  const auto rgba = cast(look(ct, {{{0, 0, {}}, {1000, 0.9, {255, 0, 0}}}}), view);
  Vec3 sum;
  double weight = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const double here = opacityAt(rgba, view, x, y);
      sum = sum + Vec3{(x + 0.5) / 100 - 1, (y + 0.5) / 100 - 1, 0} * (here * kReach_mm), weight += here;
    }
  ASSERT_GT(weight, 0);
  EXPECT_NEAR(sum.x / weight, at_mm.x, 0.2);
  EXPECT_NEAR(sum.y / weight, at_mm.y, 0.2);
}

/// Sparse noise, so that most blocks are stepped over.
TEST(RayCaster, SteppingOverBlocksLeavesNothingOut) {
  CtVolume ct(cube(45, 1.5), -1000);
  std::mt19937 random(3);
  for (int spot = 0; spot < 60; ++spot) ct.voxels[random() % ct.voxels.size()] = std::int16_t(200 + random() % 1500);
  const auto shown = look(ct, {{{-300, 0, {}}, {600, 0.6, {255, 200, 100}}}});
  CastLook everything = *shown;
  std::ranges::fill(everything.fine.seen, std::uint8_t(1));
  CastView view = straightView(120, 120);
  const double c = std::cos(0.7) * kReach_mm, s = std::sin(0.7) * kReach_mm;
  view.patientFromSeen = {c, 0, s, 0, 0, kReach_mm, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
  EXPECT_LT(std::ranges::count(shown->fine.seen, std::uint8_t(1)), std::ptrdiff_t(shown->fine.seen.size()) / 2);
  const auto some = cast(shown, view), all = cast(std::make_shared<const CastLook>(everything), view);
  int lit = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_NEAR(some[k], all[k], 3) << k;
    lit += all[k] > 20;
  }
  EXPECT_GT(lit, 200);
}

TEST(RayCaster, SurfacesShineTowardTheLamps) {
  const CastView view = straightView(40, 40);
  const auto rgba = cast(look(block(), {{{0, 0, {200, 100, 50}}, {400, 0.99, {200, 100, 50}}}}), view);
  const std::uint8_t* middle = rgba.data() + 4 * (20 * 40 + 20);
  EXPECT_GT(middle[3], 250);
  EXPECT_GT(middle[0], 150);
  EXPECT_NEAR(middle[0] - middle[1], middle[1] * 1.0, 40) << "in its colour";
}

TEST(RayCaster, TheCopyIsSmallAndAGridOfOneSliceIsDrawn) {
  VolumeGeometry grid = cube(1, 1);
  grid.size = {300, 130, 1};
  grid.spacing_mm = {0.2, 0.5, 4};
  grid.origin_mm = {-30, -32, 0};
  const auto shown = look(CtVolume(grid, 500), haze());
  const CastVolume& volume = *shown->volume;
  EXPECT_EQ(volume.coarse.size, (std::array{100, 65, 1}));
  EXPECT_EQ(volume.copy.size(), 6500u);
  EXPECT_EQ(volume.copy.front(), 500);
  const CastView view = straightView(40, 40);
  for (const bool coarse : {false, true})
    EXPECT_NEAR(opacityAt(cast(shown, view, coarse), view, 20, 20), 255 * (1 - std::pow(0.98, 4)), 3);
}

TEST(CastProp, RaysAreAsManyAsThereIsTimeFor) {
  EXPECT_EQ(CastProp::spacingFor(10'000, 1e-4), 1) << "more than one in a pixel is for nothing";
  EXPECT_EQ(CastProp::spacingFor(200'000, 4e-4), 2);
  EXPECT_EQ(CastProp::spacingFor(1e7, 1), 8);
  for (const double perRay_ms : {1e-4, 5e-4, 1e-3, 2e-3})
    for (const double pixels : {5e4, 2e5, 6e5}) {
      const double spacing = CastProp::spacingFor(pixels, perRay_ms);
      EXPECT_TRUE(spacing == 8 || pixels / spacing / spacing * perRay_ms <= 20.001) << perRay_ms;
    }
}

}  // namespace
}  // namespace insonate::views
