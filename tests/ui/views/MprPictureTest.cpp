#include "Neck.h"
#include "ui/support/Screen.h"

#include <insonate/simulator/ProbePose.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/views/MprView.h>
#include <insonate/views/UltrasoundView.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate::views {
namespace {

using test::Picture;
using test::Screen;

ImageBounds boundsOf(const Probe& probe, const ImagingSettings& settings) {
  const BeamGrid grid(probe, settings);
  return {grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()};
}

/// The CT of a case beside an image of this probe, on a display of the same size.
struct Beside {
  Beside(std::shared_ptr<const VtkCase> patient, const Probe& probe, const Transform& patientFromProbe) {
    const ImagingSettings settings = settingsFor(probe);
    picture.setBounds(boundsOf(probe, settings));
    slice.setCase(std::move(patient));
    slice.setCrosshairVisible(false);
    slice.setProbePose(patientFromProbe);
    slice.setFan(probe, settings);
    slice.setAlignedImage(boundsOf(probe, settings));
    picture.resize(500, 420);
  }
  UltrasoundView picture;
  MprView slice{SliceKind::Oblique};
};

Transform tilted() {
  return *patientFromProbe({1, -20, 2}, {0.2, 0.95, 0.1}, {0.9, -0.15, 0.4});
}

std::shared_ptr<const VtkCase> gray(int hu) {
  VolumeGeometry grid;
  grid.size = {121, 121, 121};
  grid.origin_mm = {-60, -60, -60};
  auto patient = std::make_shared<PatientCase>();
  patient->ct = CtVolume(grid, static_cast<std::int16_t>(hu));
  patient->labels = LabelMap(grid);
  return std::make_shared<VtkCase>(patient);
}

TEST(MprPicture, LiesWhereTheUltrasoundPictureLies) {
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    Beside both(gray(40), *loadProbe(name), tilted());
    both.slice.resize(500, 420);
    for (const ImagePoint point : {ImagePoint{0, 0}, {8, 20}, {-11, 33}}) {
      const DisplayPoint there = both.picture.displayFromImage(point);
      const DisplayPoint here = both.slice.displayFromPatient(tilted() * Vec3{point.lateral_mm, 0, point.axial_mm});
      EXPECT_NEAR(here.x, there.x, 1e-6) << name;
      EXPECT_NEAR(here.y, there.y, 1e-6) << name;
    }
    EXPECT_NEAR(1 / both.slice.plane().mm_per_px, both.picture.px_per_mm(), 1e-9);
  }
}

TEST(MprPicture, ShowsNothingOutsideTheFieldOfView) {
  // A curvilinear fan: beside its apex and below its arc there is tissue that the probe does not see.
  const Probe probe = *loadProbe("curvilinear");
  Beside both(gray(300), probe, *patientFromProbe({0, -40, 0}, {0, 1, 0}, {1, 0, 0}));
  both.slice.setWindowLevel({350, 50});
  Screen screen(both.slice, 500, 420);
  const Picture picture = screen.picture();
  const auto grayAt = [&](double degrees, double radius_mm) {
    const double turn = degrees * std::numbers::pi / 180;
    const DisplayPoint at =
        both.picture.displayFromImage({radius_mm * std::sin(turn), radius_mm * std::cos(turn) - probe.faceRadius_mm});
    return int(picture.at(int(at.x), int(at.y))[0]);
  };
  const double half_deg = probe.fovAngle_deg / 2, r1 = probe.faceRadius_mm, r2 = r1 + probe.defaultDepth_mm;
  for (const double share : {-0.9, -0.4, 0.35, 0.9}) {
    EXPECT_GT(grayAt(share * half_deg, r1 + 4), 200) << share;
    EXPECT_LT(grayAt(share * half_deg, r1 - 4), 60) << share;
    EXPECT_LT(grayAt(share * half_deg, r2 + 4), 60) << share;
  }
  EXPECT_LT(grayAt(half_deg + 5, r1 + 30), 60);
  EXPECT_LT(grayAt(-half_deg - 5, r1 + 30), 60);
}

TEST(MprPicture, DoesNotZoomOrPan) {
  Beside both(gray(40), *loadProbe("linear"), tilted());
  both.slice.resize(500, 420);
  const SlicePlane before = both.slice.plane();
  both.slice.wheel({{250, 200}, Button::None, false, true}, 3);
  both.slice.pressed({{250, 200}, Button::Middle});
  both.slice.moved({{300, 260}, Button::Middle});
  both.slice.released({{300, 260}, Button::Middle});
  EXPECT_EQ(both.slice.plane().mm_per_px, before.mm_per_px);
  EXPECT_EQ(both.slice.plane().center_mm, before.center_mm);
}

TEST(MprPicture, MarksWhatIsPointedAtElsewhere) {
  Beside both(gray(-1000), *loadProbe("linear"), tilted());
  Screen screen(both.slice, 500, 420);
  const Vec3 place = tilted() * Vec3{6, 0, 17};
  const DisplayPoint at = both.slice.displayFromPatient(place);
  const auto blueBeside = [&] { return int(screen.picture().at(int(at.x) + 8, int(at.y))[2]); };
  EXPECT_LT(blueBeside(), 40);
  both.slice.setPointer(place);
  EXPECT_GT(blueBeside(), 150);
  EXPECT_LT(screen.picture().at(int(at.x), int(at.y))[2], 40) << "the place itself stays in sight";
  both.slice.setPointer(tilted() * Vec3{6, 5, 17});
  EXPECT_LT(blueBeside(), 40) << "not in this plane";
}

TEST(MprPicture, ThePictureMarksItToo) {
  UltrasoundView view;
  view.setImage(test::neck().image);
  Screen screen(view, 500, 420);
  screen.picture();
  view.setPointer(ImagePoint{2, 11});
  const DisplayPoint at = view.displayFromImage({2, 11});
  const auto marked = screen.picture();
  const std::uint8_t* beside = marked.at(int(at.x) + 8, int(at.y));
  EXPECT_GT(beside[2], beside[0] + 60) << "blue";
}

TEST(MprPicture, Golden) {
  const auto& neck = test::neck();
  MprView view(SliceKind::Oblique);
  view.setCase(neck.shown);
  view.setCrosshairVisible(false);
  view.setLabelOutlines(true);
  view.setProbePose(neck.patientFromProbe);
  view.setFan(neck.setup.probe, neck.setup.settings);
  view.setAlignedImage(boundsOf(neck.setup.probe, neck.setup.settings));
  view.setPointer(neck.patientFromProbe * Vec3{4, 0, 18});
  Screen screen(view, 480, 440);
  EXPECT_TRUE(test::looksLikeGolden(screen.picture(), "views/mpr-picture"));
}

TEST(SliceCaliper, MeasuresInTheSliceWhateverItsDirection) {
  const Vec3 a{1, 2, 3};
  for (const SliceKind kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal, SliceKind::Oblique}) {
    const SliceAxes axes = sliceAxes(kind, tilted());
    const Vec3 b = a + axes.right * 6, c = b + axes.up * 8;
    const SliceCaliper distance{CaliperKind::Distance, {a, c, c}}, angle{CaliperKind::Angle, {a, b, c}},
        ellipse{CaliperKind::Ellipse, {a, b, c}};
    EXPECT_NEAR(measure(onSlice(distance, axes)).length_mm, 10, 1e-9);
    EXPECT_NEAR(measure(onSlice(angle, axes)).angle_deg, 90, 1e-9);
    EXPECT_NEAR(measure(onSlice(ellipse, axes)).width_mm, 16, 1e-9);
    EXPECT_LT(norm(fromSlice(onSlice(c, axes), axes, a) - c), 1e-9);
  }
}

TEST(SliceCaliper, IsSeenOnItsSliceOnly) {
  MprView view(SliceKind::Axial);
  view.setCase(gray(-1000));
  view.setCrosshairVisible(false);
  view.setCrosshair({0, 0, 0});
  view.setCalipers({{CaliperKind::Angle, {Vec3{-20, 0, 0}, {0, 0, 0}, {0, 20, 0}}}});
  Screen screen(view, 400, 400);
  const DisplayPoint on = view.displayFromPatient({-10, 0, 0});
  const auto brightness = [&] { return int(screen.picture().at(int(on.x), int(on.y))[1]); };
  EXPECT_GT(brightness(), 120);
  view.setCrosshair({0, 0, 5});
  EXPECT_LT(brightness(), 40);
}

/// A wire along the slice is a line, a wire through the slice a point, and a wire beside it nothing.
TEST(SlicePath, IsSeenWhereItIsNearTheSlice) {
  MprView view(SliceKind::Axial);
  view.setCase(gray(-1000));
  view.setCrosshairVisible(false);
  view.setCrosshair({0, 0, 0});
  const Color white{255, 255, 255};
  view.setToolMarks({.points_mm = {},
                     .line_mm = {},
                     .brush = {},
                     .paths = {{{{-20, 0, 0.3}, {20, 0, 0.3}}, white, 0.5},
                               {{{0, 20, -30}, {0, 20, 30}}, white, 0.5},
                               {{{-20, -20, 4}, {20, -20, 4}}, white, 0.5}}});
  Screen screen(view, 400, 400);
  const auto brightness = [&](Vec3 at_mm) {
    const DisplayPoint at = view.displayFromPatient(at_mm);
    return int(screen.picture().at(int(at.x), int(at.y))[1]);
  };
  EXPECT_GT(brightness({-10, 0, 0}), 120);
  EXPECT_GT(brightness({15, 0, 0}), 120);
  EXPECT_GT(brightness({0, 20, 0}), 120) << "where it crosses";
  EXPECT_LT(brightness({6, 20, 0}), 40);
  EXPECT_LT(brightness({10, -20, 0}), 40);
}

}  // namespace
}  // namespace insonate::views
