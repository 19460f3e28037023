#include "Neck.h"
#include "ui/support/Screen.h"

#include <insonate/tissue/Labels.h>
#include <insonate/views/MprView.h>

#include <gtest/gtest.h>

#include <cmath>

namespace insonate::views {
namespace {

using test::Picture;
using test::Screen;

/// Extent of what is brighter than its surround.
struct Spot {
  double x = 0, y = 0;
  int width = 0, height = 0;
};
Spot brightSpot(const Picture& picture) {
  int low[2] = {picture.width, picture.height}, high[2] = {-1, -1};
  for (int y = 60; y < picture.height - 60; ++y)
    for (int x = 60; x < picture.width - 60; ++x)
      if (picture.at(x, y)[0] > 127)
        low[0] = std::min(low[0], x), high[0] = std::max(high[0], x), low[1] = std::min(low[1], y),
        high[1] = std::max(high[1], y);
  return {0.5 * (low[0] + high[0] + 1), 0.5 * (low[1] + high[1] + 1), high[0] - low[0] + 1, high[1] - low[1] + 1};
}

std::shared_ptr<const VtkCase> bright(const VolumeGeometry& grid, int i, int j, int k) {
  return std::make_shared<VtkCase>(test::oneVoxel(grid, i, j, k));
}

void plain(MprView& view) {
  view.setCrosshairVisible(false);
  view.setLabelsVisible(false);
  view.setWindowLevel({2000, 0});
}

TEST(MprView, PatientsLeftAppearsOnTheRightOfAnAxialSlice) {
  VolumeGeometry grid;
  grid.size = {41, 41, 5};
  grid.origin_mm = {-20, -20, 0};
  MprView view(SliceKind::Axial);
  view.setCase(bright(grid, 30, 10, 2));  // 10 mm to the left, 10 mm to the front
  plain(view);
  Screen screen(view, 400, 400);
  const Spot spot = brightSpot(screen.picture());
  EXPECT_GT(spot.x, 250);
  EXPECT_LT(spot.y, 150);
  const DisplayPoint expected = view.displayFromPatient({10, -10, 2});
  EXPECT_NEAR(spot.x, expected.x, 1);
  EXPECT_NEAR(spot.y, expected.y, 1);
}

TEST(MprView, AnisotropicVoxelsKeepTheirAspect) {
  VolumeGeometry grid;
  grid.size = {61, 61, 13};
  grid.spacing_mm = {1, 1, 5};
  grid.origin_mm = {-30, -30, -30};
  MprView view(SliceKind::Coronal);
  view.setCase(bright(grid, 30, 30, 6));
  plain(view);
  Screen screen(view, 600, 600);
  const Spot spot = brightSpot(screen.picture());
  EXPECT_NEAR(double(spot.height) / spot.width, 5, 0.6);
  EXPECT_NEAR(spot.x, 300, 1.5);
}

TEST(MprView, ObliqueLeftHandedGridsAppearWhereTheyAre) {
  const double c = std::cos(0.5), s = std::sin(0.5);
  VolumeGeometry grid;
  grid.size = {40, 40, 20};
  grid.spacing_mm = {1, 1, 2};
  grid.origin_mm = {50, -70, 300};
  grid.direction = {{Vec3{c, 0, s}, Vec3{0, 1, 0}, Vec3{s, 0, -c}}};
  ASSERT_LT(std::abs(std::abs(determinant(grid.direction)) - 1), 1e-9);
  MprView view(SliceKind::Sagittal);
  view.setCase(bright(grid, 10, 28, 5));
  plain(view);
  const Vec3 at_mm = grid.patientFromIndex() * Vec3{10, 28, 5};
  view.setCrosshair(at_mm);
  Screen screen(view, 500, 500);
  const Spot spot = brightSpot(screen.picture());
  const DisplayPoint expected = view.displayFromPatient(at_mm);
  EXPECT_NEAR(spot.x, expected.x, 2);
  EXPECT_NEAR(spot.y, expected.y, 2);
}

TEST(MprView, WheelAndKeysStepThroughSlicesAndStopAtTheEnds) {
  VolumeGeometry grid;
  grid.size = {20, 20, 10};
  grid.spacing_mm = {1, 1, 3};
  MprView view(SliceKind::Axial);
  view.setCase(bright(grid, 5, 5, 5));
  Vec3 heard{};
  view.setCrosshairMoved([&](Vec3 position_mm) { heard = position_mm; });
  view.setCrosshair({4, 7, 12});
  EXPECT_EQ(heard, Vec3{});
  view.wheel({}, 1);
  EXPECT_NEAR(heard.z, 15, 1e-9);
  EXPECT_NEAR(heard.x, 4, 1e-9);
  view.wheel({}, 0.5);
  EXPECT_NEAR(view.crosshair_mm().z, 15, 1e-9);
  view.wheel({}, 0.5);
  EXPECT_NEAR(view.crosshair_mm().z, 18, 1e-9);
  view.key(Key::Down);
  EXPECT_NEAR(view.crosshair_mm().z, 15, 1e-9);
  view.stepSlices(100);
  EXPECT_NEAR(view.crosshair_mm().z, 27, 1e-9);
  view.stepSlices(-100);
  EXPECT_NEAR(view.crosshair_mm().z, 0, 1e-9);
}

TEST(MprView, DraggingMovesCrosshairAndWindow) {
  VolumeGeometry grid;
  grid.size = {20, 20, 10};
  MprView view(SliceKind::Axial);
  view.setCase(bright(grid, 5, 5, 5));
  view.resize(300, 300);
  EXPECT_TRUE(view.pressed({{100, 120}, Button::Left}));
  const Vec3 there = view.patientFromDisplay({100, 120});
  EXPECT_NEAR(norm(view.crosshair_mm() - there), 0, 1e-9);
  view.released({{100, 120}, Button::Left});
  const WindowLevel before = view.windowLevel();
  view.pressed({{100, 100}, Button::Right});
  view.moved({{130, 80}, Button::Right});
  EXPECT_GT(view.windowLevel().window_HU, before.window_HU);
  EXPECT_LT(view.windowLevel().level_HU, before.level_HU);
  EXPECT_TRUE(view.released({{130, 80}, Button::Right}));
  EXPECT_FALSE(view.moved({{140, 80}, Button::None}));
}

TEST(MprView, ZoomKeepsWhatIsUnderThePointer) {
  MprView view(SliceKind::Axial);
  view.setCase(test::neck().shown);
  view.resize(400, 300);
  const Pointer pointer{{120, 80}, Button::None, false, true};
  const Vec3 before = view.patientFromDisplay(pointer.at);
  view.wheel(pointer, 3);
  EXPECT_NEAR(norm(view.patientFromDisplay(pointer.at) - before), 0, 1e-9);
}

TEST(MprView, WhatIsZoomedInOnStaysInSightWhenTheViewShrinks) {
  MprView view(SliceKind::Axial);
  view.setCase(test::neck().shown);
  view.resize(800, 800);
  view.zoom(4);
  const Vec3 corner_mm = view.patientFromDisplay({20, 20});
  view.resize(400, 400);
  const DisplayPoint at = view.displayFromPatient(corner_mm);
  EXPECT_NEAR(at.x, 10, 0.01);
  EXPECT_NEAR(at.y, 10, 0.01);
  view.resize(800, 800);
  EXPECT_LT(norm(view.patientFromDisplay({20, 20}) - corner_mm), 1e-6) << "and back";
}

TEST(MprView, EditedLabelsAreDrawnAtTheNextRendering) {
  VolumeGeometry grid;
  grid.size = {21, 21, 3};
  const auto shown = std::make_shared<VtkCase>(test::oneVoxel(grid, 0, 0, 0));
  const auto edited = std::make_shared<LabelMap>(grid);
  shown->setLabels(edited);
  MprView view(SliceKind::Axial);
  view.setCase(shown);
  view.setCrosshairVisible(false);
  view.setLabelOpacity(1);
  Screen screen(view, 210, 210);
  EXPECT_EQ(screen.picture().at(105, 105)[2], 0);
  edited->at(10, 10, 1) = kVein;
  shown->labelsChanged();
  const Picture after = screen.picture();
  EXPECT_EQ(after.at(105, 105)[0], 0);
  EXPECT_NEAR(after.at(105, 105)[1], 151, 2);
  EXPECT_NEAR(after.at(105, 105)[2], 206, 2);
}

TEST(MprView, Golden) {
  for (const auto& [kind, name] : {std::pair{SliceKind::Axial, "mpr-axial"},
                                   {SliceKind::Coronal, "mpr-coronal"},
                                   {SliceKind::Sagittal, "mpr-sagittal"},
                                   {SliceKind::Oblique, "mpr-oblique"}}) {
    MprView view(kind);
    view.setCase(test::neck().shown);
    view.setCrosshair(test::neck().patient->manifest.targets.front().position_mm);
    view.setProbePose(test::neck().patientFromProbe);
    view.setFan(test::neck().setup.probe, test::neck().setup.settings);
    Screen screen(view, 400, 360);
    EXPECT_TRUE(test::looksLikeGolden(screen.picture(), std::string("views/") + name));
  }
}

TEST(MprView, OutlinesAreAsThickAsWantedAndFillGoesWithout) {
  VolumeGeometry grid;
  grid.size = {40, 40, 3};
  PatientCase patient{{}, CtVolume(grid, -1000), LabelMap(grid)};
  for (int j = 10; j < 30; ++j)
    for (int i = 10; i < 30; ++i) patient.labels.at(i, j, 1) = kVein;
  MprView view(SliceKind::Axial);
  view.setCase(std::make_shared<VtkCase>(std::make_shared<const PatientCase>(std::move(patient))));
  view.setCrosshairVisible(false);
  view.setLabelColor(kVein, {0, 255, 0});
  Screen screen(view, 400, 400);
  // Along a line through the middle, where no words are.
  const auto painted = [&](LabelStyle style) {
    view.setLabelStyle(style);
    const Picture picture = screen.picture();
    int pixels = 0;
    for (int x = 60; x < 340; ++x) pixels += picture.at(x, 170)[1] > 40 && picture.at(x, 170)[0] < 20;
    return pixels;
  };
  const int one = painted({.fill = false, .thickness_px = 1});
  EXPECT_NEAR(one, 2, 1) << "either side";
  EXPECT_NEAR(painted({.fill = false, .thickness_px = 4}), 4 * one, 3);
  const int filled = painted({.outline = false});
  EXPECT_GT(filled, 100);
  view.setRelativeLabelOpacity(kVein, 0);
  EXPECT_EQ(painted({}), 0);
  view.setRelativeLabelOpacity(kVein, 1);
  EXPECT_EQ(painted({}), filled);
}

}  // namespace
}  // namespace insonate::views
