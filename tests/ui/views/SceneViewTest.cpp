#include "Neck.h"
#include "ui/support/Screen.h"

#include <insonate/surface/ExtractSurface.h>
#include <insonate/tissue/Labels.h>
#include <insonate/views/SceneView.h>

#include <gtest/gtest.h>

#include <cmath>

namespace insonate::views {
namespace {

using test::Picture;
using test::Screen;

Surface surfaceOf(const Mesh& mesh) {
  return {mesh.points_mm, mesh.normals, mesh.triangles};
}

/// An axis-aligned box with outward triangles and no normals.
Mesh box(Vec3 middle, Vec3 half) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      mesh.points_mm.push_back(static_cast<float>(middle[axis] + (corner >> axis & 1 ? half[axis] : -half[axis])));
  mesh.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return mesh;
}

int redAt(const Picture& picture, DisplayPoint at) {
  const auto* rgb =
      picture.at(std::clamp(int(at.x), 0, picture.width - 1), std::clamp(int(at.y), 0, picture.height - 1));
  return int(rgb[0]) - std::max(rgb[1], rgb[2]);
}

/// A gray body with a small red box 30 mm to the patient's left, in front and high.
void marked(SceneView& view) {
  view.setSurface(kSoftTissue, surfaceOf(box({0, 0, 0}, {40, 40, 40})));
  view.setColor(kSoftTissue, {90, 90, 90});
  view.setSurface(kArtery, surfaceOf(box({30, -42, 30}, {4, 4, 4})));
  view.setColor(kArtery, {255, 0, 0});
}

TEST(SceneView, PatientsLeftIsOnTheRightSeenFromTheFront) {
  SceneView view;
  marked(view);
  Screen screen(view, 400, 400);
  const Picture picture = screen.picture();
  const DisplayPoint at = view.displayFromPatient({30, -46, 30});
  EXPECT_GT(at.x, 240);
  EXPECT_LT(at.y, 160);
  EXPECT_GT(redAt(picture, at), 60);
  EXPECT_LT(redAt(picture, {400 - at.x, at.y}), 20);
}

TEST(SceneView, TheTrayStandsWhereItIsPutUntilItIsTakenAway) {
  SceneView view;
  marked(view);
  Screen screen(view, 400, 400);
  screen.picture();
  // Facing the viewer, before the body.
  const Transform tray{{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}}, {0, -60, -20}};
  const DisplayPoint floor = view.displayFromPatient(tray * Vec3{0, 15, 0});
  const auto steel = [&] {
    const Picture picture = screen.picture();
    const auto* rgb = picture.at(int(floor.x), int(floor.y));
    return int(rgb[2]) > int(rgb[0]) + 5;  // its gray is bluish, the body's is not
  };
  EXPECT_FALSE(steel());
  view.setTray(tray);
  EXPECT_TRUE(steel());
  view.setTray(std::nullopt);
  EXPECT_FALSE(steel());
}

TEST(SceneView, EachViewpointShowsItsSide) {
  SceneView view;
  marked(view);
  Screen screen(view, 400, 400);
  view.setViewpoint(Viewpoint::Posterior);
  EXPECT_LT(view.displayFromPatient({30, 0, 0}).x, 200);
  view.setViewpoint(Viewpoint::Left);
  EXPECT_LT(view.displayFromPatient({0, -30, 0}).x, 200);
  view.setViewpoint(Viewpoint::Right);
  EXPECT_GT(view.displayFromPatient({0, -30, 0}).x, 200);
  view.setViewpoint(Viewpoint::Superior);
  EXPECT_LT(view.displayFromPatient({30, 0, 0}).x, 200);
  EXPECT_LT(view.displayFromPatient({0, -30, 0}).y, 200);
  view.setViewpoint(Viewpoint::Inferior);
  EXPECT_GT(view.displayFromPatient({30, 0, 0}).x, 200);
  EXPECT_LT(view.displayFromPatient({0, -30, 0}).y, 200);
}

TEST(SceneView, ImagePlaneLiesWhereThePoseSaysAndEndsWithTheFieldOfView) {
  SceneView view;
  Probe probe = loadProbe("linear").value();
  const ImagingSettings settings = settingsFor(probe);
  marked(view);
  view.setVisible(kSoftTissue, false);
  view.setVisible(kArtery, false);
  view.setProbe(probe, settings);
  view.setProbeVisible(false);
  BModeImage image{200, 200, 0.3, -29.85, -9.85, std::vector<std::uint8_t>(200 * 200, 230)};
  view.setImage(image);
  // Seen from the front: lateral to the patient's left, axial downward.
  view.setProbePose({{{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}}}, {5, 0, 20}});
  view.setViewpoint(Viewpoint::Anterior);
  Screen screen(view, 400, 400);
  const Picture picture = screen.picture();
  const auto gray = [&](Vec3 point) {
    const DisplayPoint at = view.displayFromPatient(point);
    return int(picture.at(int(at.x), int(at.y))[0]);
  };
  const double half = probe.width_mm / 2, depth = settings.depth_mm;
  EXPECT_NEAR(gray({5, 0, 20 - depth / 2}), 230, 3);
  EXPECT_NEAR(gray({5 + half - 1.5, 0, 18}), 230, 3);
  EXPECT_LT(gray({5 + half + 1.5, 0, 18}), 60);
  EXPECT_LT(gray({5, 0, 22}), 60);
  EXPECT_LT(gray({5, 0, 20 - depth - 2}), 60);
}

TEST(SceneView, ClippingTakesAwayWhatIsBehindThePlane) {
  SceneView view;
  marked(view);
  Screen screen(view, 400, 400);
  view.setClipping({ClippingKind::Axial, 20, true});
  const Picture picture = screen.picture();
  EXPECT_LT(redAt(picture, view.displayFromPatient({30, -46, 30})), 20);
}

TEST(SceneView, PicksTheFirstVisibleVoxel) {
  SceneView view;
  view.setCase(test::neck().shown);
  Screen screen(view, 400, 400);
  const Vec3 vein = test::neck().patient->manifest.targets.front().position_mm;
  const auto skin = view.pick(view.displayFromPatient(vein));
  ASSERT_TRUE(skin);
  EXPECT_EQ(skin->label, kSkin);
  EXPECT_LT(skin->position_mm.y, vein.y);
  const auto through = view.pick(view.displayFromPatient(vein), 0.5);
  ASSERT_TRUE(through);
  EXPECT_NE(through->label, kSkin) << "is translucent";
  EXPECT_GT(through->position_mm.y, skin->position_mm.y);
  for (int label = 1; label < kLabelCount; ++label) view.setVisible(static_cast<std::uint8_t>(label), label == kVein);
  const auto inside = view.pick(view.displayFromPatient(vein));
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->label, kVein);
  EXPECT_LT(norm(inside->position_mm - vein), 20);
  EXPECT_FALSE(view.pick({2, 2}));
}

TEST(SceneView, PathsAreSeenWhereTheyAreUntilOthersAreSet) {
  SceneView view;
  view.setSurface(kSoftTissue, surfaceOf(box({0, 0, 0}, {40, 40, 40})));
  view.setColor(kSoftTissue, {90, 90, 90});
  Screen screen(view, 400, 400);
  const auto along = [](double x) { return std::vector<Vec3>{{x, -44, -20}, {x, -44, 0}, {x, -44, 20}}; };
  view.setPaths({{along(20), {255, 0, 0}}, {along(-20), {0, 0, 255}}, {{{0, -44, 0}}, {255, 0, 0}}});
  const Picture picture = screen.picture();
  EXPECT_GT(redAt(picture, view.displayFromPatient({20, -44, 10})), 60);
  EXPECT_LT(redAt(picture, view.displayFromPatient({-20, -44, 10})), -60) << "the blue one";
  EXPECT_LT(redAt(picture, view.displayFromPatient({0, -44, 0})), 20) << "one point is no path";
  view.setPaths({});
  EXPECT_LT(redAt(screen.picture(), view.displayFromPatient({20, -44, 10})), 20);
}

TEST(SceneView, PathsAreAsThickAsTheyState) {
  SceneView view;
  view.setSurface(kSoftTissue, surfaceOf(box({0, 0, 0}, {40, 40, 40})));
  view.setColor(kSoftTissue, {90, 90, 90});
  Screen screen(view, 400, 400);
  const auto along = [](double x) { return std::vector<Vec3>{{x, -50, -20}, {x, -50, 0}, {x, -50, 20}}; };
  view.setPaths({{along(20), {255, 0, 0}, 5}, {along(-20), {255, 0, 0}, 1}});
  const Picture picture = screen.picture();
  EXPECT_GT(redAt(picture, view.displayFromPatient({23, -50, 0})), 60);
  EXPECT_GT(redAt(picture, view.displayFromPatient({-20, -50, 0})), 60);
  EXPECT_LT(redAt(picture, view.displayFromPatient({-17, -50, 0})), 20);
}

TEST(SceneView, HeadCouplingKeepsTheScreenStillAndMovesWhatIsBehind) {
  SceneView view;
  marked(view);
  Screen screen(view, 400, 250);
  HeadCoupling coupling;
  // The screen faces the patient's front, one screen millimeter to a millimeter of the patient.
  coupling.patientFromScreen = {{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}}, {0, 0, 0}};
  coupling.width_mm = 200, coupling.height_mm = 125;
  coupling.eye_mm = {0, 0, 500};
  view.setHeadCoupling(coupling);
  const DisplayPoint still = view.displayFromPatient({50, 0, 25});
  EXPECT_NEAR(still.x, 300, 1e-3);
  EXPECT_NEAR(still.y, 75, 1e-3);
  coupling.eye_mm = {100, 40, 500};
  view.setHeadCoupling(coupling);
  const DisplayPoint same = view.displayFromPatient({50, 0, 25});
  EXPECT_NEAR(same.x, 300, 1e-3);
  EXPECT_NEAR(same.y, 75, 1e-3);
  // A point 100 mm behind the screen follows the eye by 100/600 of its way: 16.7 mm, at 2 pixels a millimeter.
  const DisplayPoint behind = view.displayFromPatient({0, 100, 0});
  EXPECT_NEAR(behind.x, 200 + 2 * 100.0 / 6, 1e-3);
  EXPECT_NEAR(behind.y, 125 - 2 * 40.0 / 6, 1e-3);
  view.setHeadCoupling(std::nullopt);
  EXPECT_GT(screen.picture().width, 0);
}

TEST(SceneView, StereoGivesEachEyeItsOwnPicture) {
  SceneView view;
  marked(view);
  Screen screen(view, 400, 200);
  view.setStereo(Stereo::SideBySide);
  const Picture picture = screen.picture();
  int differing = 0;
  for (int y = 20; y < 180; ++y)
    for (int x = 0; x < 180; ++x) differing += std::abs(picture.at(x, y)[0] - picture.at(x + 200, y)[0]) > 30;
  EXPECT_GT(differing, 20);
}

TEST(SceneView, DraggingTurnsAndDrawsCoarser) {
  SceneView view;
  marked(view);
  Screen screen(view, 400, 400);
  const DisplayPoint before = view.displayFromPatient({0, -40, 0});
  EXPECT_TRUE(view.pressed({{200, 200}, Button::Left}));
  view.moved({{260, 200}, Button::Left});
  const DisplayPoint after = view.displayFromPatient({0, -40, 0});
  EXPECT_TRUE(view.released({{260, 200}, Button::Left}));
  EXPECT_GT(after.x, before.x + 5);
}

void addNeck(SceneView& view) {
  const PatientCase& patient = *test::neck().patient;
  view.setCase(test::neck().shown);
  view.setSurface(kSkin, surfaceOf(extractBody(patient.labels).value()));
  for (const Label label : {kArtery, kVein, kThyroid, kBone, kAirway, kSternocleidomastoid})
    view.setSurface(label, surfaceOf(extractSurface(patient.labels, label).value()));
}

TEST(SceneView, Golden) {
  SceneView view;
  addNeck(view);
  view.setProbe(test::neck().setup.probe, test::neck().setup.settings);
  view.setProbePose(test::neck().patientFromProbe);
  view.setImage(test::neck().image);
  Screen screen(view, 480, 400);
  view.orbit(-25, 38);
  view.zoom(1.2);
  EXPECT_TRUE(test::looksLikeGolden(screen.picture(), "views/scene", {32, 0.02}));
  view.setMoving(true);
  EXPECT_TRUE(test::looksLikeGolden(screen.picture(), "views/scene-moving", {32, 0.03}));
  view.setMoving(false);
  view.setViewpoint(Viewpoint::Anterior);
  view.setCtVisible(true);
  for (const Label label : {kSkin, kBone, kAirway, kSternocleidomastoid}) view.setVisible(label, false);
  ASSERT_TRUE(view.renderExactly());
  EXPECT_TRUE(test::looksLikeGolden(screen.picture(), "views/scene-ct", {32, 0.03}));
}

}  // namespace
}  // namespace insonate::views
