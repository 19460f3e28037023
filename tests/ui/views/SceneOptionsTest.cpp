#include "Neck.h"
#include "ui/support/Screen.h"

#include <insonate/surface/ExtractSurface.h>
#include <insonate/tissue/Labels.h>
#include <insonate/views/SceneTiming.h>
#include <insonate/views/SceneView.h>

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <cmath>

namespace insonate::views {
namespace {

using test::Picture;
using test::Screen;

/// The neck with few structures, its screen made once.
class SceneOptions : public testing::Test {
 protected:
  SceneOptions() {
    const PatientCase& patient = *test::neck().patient;
    view.setCase(test::neck().shown);
    for (const auto& [label, mesh] : meshes()) view.setSurface(label, {mesh.points_mm, mesh.normals, mesh.triangles});
    middle = patient.ct.geometry.center_mm();
  }
  static const std::vector<std::pair<std::uint8_t, Mesh>>& meshes() {
    static const auto made = [] {
      const LabelMap& labels = test::neck().patient->labels;
      std::vector<std::pair<std::uint8_t, Mesh>> all{{kSkin, extractBody(labels, {8, 3}).value()}};
      for (const Label label : {kArtery, kVein, kThyroid, kBone, kAirway})
        all.emplace_back(label, extractSurface(labels, label, {4, 1.5}).value());
      return all;
    }();
    return made;
  }

  SceneView view;
  Vec3 middle;
};

int differing(const Picture& a, const Picture& b) {
  int count = 0;
  for (std::size_t k = 0; k < a.rgb.size(); k += 3) count += std::abs(int(a.rgb[k]) - int(b.rgb[k])) > 24;
  return count;
}

TEST_F(SceneOptions, EachKindOfClippingLiesWhereItSays) {
  EXPECT_FALSE(view.clippingPlane());
  const struct {
    ClippingKind kind;
    Vec3 normal;
  } kinds[] = {
      {ClippingKind::Axial, {0, 0, 1}}, {ClippingKind::Coronal, {0, 1, 0}}, {ClippingKind::Sagittal, {1, 0, 0}}};
  for (const auto& [kind, normal] : kinds) {
    view.setClipping({kind, 12});
    ASSERT_TRUE(view.clippingPlane());
    EXPECT_LT(norm(view.clippingPlane()->point_mm - (middle + normal * 12)), 1e-6);
    EXPECT_LT(norm(view.clippingPlane()->normal - normal), 1e-9);
    view.setClipping({kind, 12, true});
    EXPECT_LT(norm(view.clippingPlane()->point_mm - (middle + normal * 12)), 1e-6) << "flipping does not move it";
    EXPECT_LT(norm(view.clippingPlane()->normal + normal), 1e-9);
  }
  view.setClipping({ClippingKind::Free, 5, false, {0, 3, 4}});
  EXPECT_LT(norm(view.clippingPlane()->normal - Vec3{0, 0.6, 0.8}), 1e-9);
  view.setClipping({ClippingKind::Free, 0, false, {0, 0, 0}});
  EXPECT_TRUE(std::isfinite(norm(view.clippingPlane()->normal)));
}

TEST_F(SceneOptions, TheReachEndsAtTheCt) {
  const VolumeGeometry& grid = test::neck().patient->ct.geometry;
  EXPECT_NEAR(view.maxClippingOffset_mm({ClippingKind::Sagittal}), grid.size[0] * grid.spacing_mm.x / 2, 1e-6);
  EXPECT_NEAR(view.maxClippingOffset_mm({ClippingKind::Axial}), grid.size[2] * grid.spacing_mm.z / 2, 1e-6);
}

TEST_F(SceneOptions, TheImagePlaneCutsWhereTheProbeIs) {
  view.setClipping({ClippingKind::ImagePlane});
  EXPECT_FALSE(view.clippingPlane()) << "there is no probe yet";
  view.setProbe(test::neck().setup.probe, test::neck().setup.settings);
  view.setProbePose(test::neck().patientFromProbe);
  const Transform& pose = test::neck().patientFromProbe;
  ASSERT_TRUE(view.clippingPlane());
  EXPECT_LT(norm(view.clippingPlane()->point_mm - pose.offset), 1e-9);
  EXPECT_LT(norm(view.clippingPlane()->normal - pose.linear.column[1]), 1e-9);
  Transform moved = pose;
  moved.offset = moved.offset + Vec3{0, 0, 9};
  view.setProbePose(moved);
  EXPECT_LT(norm(view.clippingPlane()->point_mm - moved.offset), 1e-9) << "the plane goes with the probe";
}

TEST_F(SceneOptions, ClippedGolden) {
  Screen screen(view, 400, 360);
  view.orbit(-30, 20);
  view.setClipping({ClippingKind::Axial, 4, true});
  view.setViewpoint(Viewpoint::Superior);
  view.orbit(0, -35);
  EXPECT_TRUE(test::looksLikeGolden(screen.picture(), "views/scene-clipped", {32, 0.02}));
}

TEST_F(SceneOptions, StereoAnaglyphGolden) {
  Screen screen(view, 400, 360);
  view.orbit(-25, 15);
  const Picture plain = screen.picture();
  view.setStereo(Stereo::Anaglyph);
  EXPECT_TRUE(test::looksLikeGolden(screen.picture(), "views/scene-anaglyph", {32, 0.02}));
  view.setStereo(Stereo::LeftEye);
  const Picture left = screen.picture();
  view.setStereo(Stereo::RightEye);
  const Picture right = screen.picture();
  EXPECT_GT(differing(left, right), 400);
  EXPECT_GT(differing(left, plain), 100);
  view.setStereo(Stereo::Off);
  EXPECT_LT(differing(screen.picture(), plain), 20);
}

TEST_F(SceneOptions, ShutterGlassesNeedAWindowForThem) {
  EXPECT_FALSE(view.supports(Stereo::QuadBuffer)) << "without a window";
  EXPECT_TRUE(view.supports(Stereo::Anaglyph));
  Screen screen(view, 64, 64);
  EXPECT_FALSE(view.supports(Stereo::QuadBuffer));
}

TEST_F(SceneOptions, TheScreenStandsWhereTheCameraLooks) {
  Screen screen(view, 500, 400);
  view.setViewpoint(Viewpoint::Left);
  const DisplayPoint center = view.displayFromPatient(middle);
  EXPECT_NEAR(view.viewerDirection().x, 1, 1e-9);
  screen.picture();
  const double* focus = view.renderer()->GetActiveCamera()->GetFocalPoint();
  const Vec3 inPlane = Vec3{focus[0], focus[1], focus[2]} + Vec3{0, 25, -30};
  const DisplayPoint usual = view.displayFromPatient(inPlane);
  HeadCoupling coupling;
  coupling.width_mm = 250;
  for (const Vec3 eye : {Vec3{0, 0, 500}, Vec3{-120, 80, 350}}) {
    coupling.eye_mm = eye;
    view.setHeadCoupling(coupling);
    EXPECT_NEAR(view.displayFromPatient(inPlane).x, usual.x, 1e-3) << "as large as the usual camera shows it";
    EXPECT_NEAR(view.displayFromPatient(inPlane).y, usual.y, 1e-3);
  }
  view.orbit(30, 0);
  EXPECT_GT(std::abs(view.displayFromPatient(inPlane).x - usual.x), 2) << "turning goes on working";
  view.orbit(-30, 0);
  view.setHeadCoupling(std::nullopt);
  EXPECT_NEAR(view.displayFromPatient(middle).x, center.x, 1e-3);
}

/// Eye and screen against similar triangles. The view is 500 pixels wide for 250 mm: two pixels a millimeter.
TEST_F(SceneOptions, PointsOnTheScreenStayAndThoseBehindFollowTheEye) {
  Screen screen(view, 500, 400);
  HeadCoupling coupling;
  coupling.width_mm = 250;
  coupling.patientFromScreen = Transform{{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}}, middle};
  for (const Vec3 eye : {Vec3{0, 0, 400}, Vec3{-150, 0, 400}, Vec3{90, 70, 250}, Vec3{0, -60, 900}}) {
    coupling.eye_mm = eye;
    view.setHeadCoupling(coupling);
    const auto at = [&](Vec3 onScreen_mm) {
      return view.displayFromPatient(*coupling.patientFromScreen * onScreen_mm);
    };
    for (const Vec3 point : {Vec3{0, 0, 0}, Vec3{60, -40, 0}, Vec3{-125, 100, 0}}) {
      EXPECT_NEAR(at(point).x, 250 + 2 * point.x, 1e-3);
      EXPECT_NEAR(at(point).y, 200 - 2 * point.y, 1e-3);
    }
    for (const Vec3 point : {Vec3{0, 0, -100}, Vec3{30, 20, -50}, Vec3{10, 0, 60}}) {
      const double share = -point.z / (eye.z - point.z);
      EXPECT_NEAR(at(point).x, 250 + 2 * (point.x + (eye.x - point.x) * share), 1e-3);
      EXPECT_NEAR(at(point).y, 200 - 2 * (point.y + (eye.y - point.y) * share), 1e-3);
    }
  }
}

TEST_F(SceneOptions, MeasuresHowFastTheSceneTurns) {
  Screen screen(view, 300, 240);
  const Picture still = screen.picture();
  const DisplayPoint before = view.displayFromPatient(middle + Vec3{20, -30, 0});
  const FrameTimes times = timeOrbit(view, 5);
  EXPECT_EQ(times.moving_ms.size(), 5u);
  for (const double ms : times.moving_ms) EXPECT_GT(ms, 0);
  EXPECT_GT(times.still_ms, 0);
  EXPECT_GE(times.percentile95_ms(), times.median_ms());
  EXPECT_NEAR(times.perSecond() * times.median_ms(), 1000, 1e-6);
  EXPECT_FALSE(view.isMoving());
  const DisplayPoint after = view.displayFromPatient(middle + Vec3{20, -30, 0});
  EXPECT_NEAR(after.x, before.x, 1e-3) << "the camera is back";
  EXPECT_LT(differing(screen.picture(), still), 20) << "and the picture of rest exact";
  EXPECT_EQ(timeOrbit(view, 0).moving_ms.size(), 0u);
  EXPECT_EQ(FrameTimes{}.perSecond(), 0);
}

}  // namespace
}  // namespace insonate::views
