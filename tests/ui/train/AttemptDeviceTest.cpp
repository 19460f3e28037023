#include "AttemptWindow.h"
#include "Stylus.h"
#include "patient3d/PatientViews.h"
#include "patient3d/SceneNeedle.h"

#include <gmock/gmock.h>

#include <cmath>

namespace insonate::train {
namespace {

class AttemptByDevice : public AttemptWindow {};

TEST_F(AttemptByDevice, ButtonsOfTheNeedlesDeviceTurnThePatientAndDraw) {
  openWide();
  const auto stylus = std::make_shared<Stylus>();
  hands().session().devices().add(stylus);
  hands().assign(kNeedleTool, "stylus");
  ASSERT_TRUE(waitFor([&] { return hands().needle().has_value(); }));
  double across_deg = 0;
  QObject::connect(&hands(), &HapticControl::anatomyTurned, workspace_.get(),
                   [&](double across, double) { across_deg += across; });
  const auto turnBy = [&](double degrees) {
    for (int i = 0; i < 10; ++i) {
      stylus->turn_rad = stylus->turn_rad + degrees / 10 * 3.14159265358979 / 180;
      QTest::qWait(40);
    }
    QTest::qWait(100);
  };
  turnBy(20);
  EXPECT_EQ(across_deg, 0) << "no button is down";
  stylus->buttons = 1;
  QTest::qWait(100);
  turnBy(30);
  EXPECT_NEAR(across_deg, -30, 0.5) << "the patient goes along with the hand";
  stylus->buttons = 2;
  EXPECT_TRUE(waitFor([&] { return attempt_->isAspirating(); }));
  stylus->buttons = 0;
  EXPECT_TRUE(waitFor([&] { return !attempt_->isAspirating(); }));
  hands().assign(kNeedleTool, {});
}

/// In the vein, frozen while the hand goes on, let go, drawn out, and carried to the tray: all by the device.
TEST_F(AttemptByDevice, ANeedleInADeviceIsFrozenDrawnOutAndReplacedAtTheTray) {
  openWide();
  const auto stylus = std::make_shared<Stylus>();
  hands().session().devices().add(stylus);
  hands().assign(kNeedleTool, "stylus");
  start();
  ASSERT_TRUE(waitFor([&] { return hands().needle().has_value(); }));
  const auto tip = [&] { return hands().needle()->patientFromNeedle.offset; };
  // Seen from the patient's head, as devices stand at first: their right is the patient's right, their up the front.
  const auto moveBy = [&](Vec3 way_mm, double step_mm) {
    const int steps = int(std::ceil(norm(way_mm) / step_mm));
    for (int i = 0; i < steps; ++i) {
      stylus->x_mm = stylus->x_mm - way_mm.x / steps;
      stylus->y_mm = stylus->y_mm - way_mm.y / steps;
      stylus->z_mm = stylus->z_mm + way_mm.z / steps;
      QTest::qWait(10);
    }
    QTest::qWait(200);
  };
  const Vec3 axis = hands().needle()->patientFromNeedle.linear.column[2];
  moveBy(axis * -8, 5);
  const Vec3 middle{0, 12, tip().z + 12};  // of the vein, beside the image
  moveBy(middle - axis * 25 - tip(), 5);
  ASSERT_LT(norm(middle - axis * 25 - tip()), 0.1) << "the device leads the needle";
  moveBy(axis * 25, 0.5);
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));

  key(Qt::Key_Space);
  ASSERT_TRUE(model_->live.isFrozen());
  QTest::qWait(100);
  const Vec3 frozen = tip();
  moveBy(axis * 12 + Vec3{0, 0, 4}, 0.5);
  EXPECT_EQ(tip(), frozen) << "the hand went on through the back wall";
  EXPECT_EQ(attempt_->view().metrics[Metric::PosteriorWallPunctures], 0);
  key(Qt::Key_Space);
  QTest::qWait(200);
  EXPECT_LT(norm(tip() - frozen), 0.1) << "it goes on from where it was frozen";
  EXPECT_EQ(attempt_->view().needle, NeedlePlace::Vein);

  moveBy(axis * -40, 0.5);
  EXPECT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Used; }));
  auto* scene = workspace_->findChild<ui::ViewWidget*>("sceneView");
  const auto& patient = *static_cast<PatientViews*>(scene->parentWidget()->parentWidget());
  ASSERT_TRUE(patient.needle().tray());
  moveBy(Vec3{0, -60, 0}, 10);  // over the patient
  moveBy(*patient.needle().tray() * Vec3{10, 5, 60} - tip(), 10);
  EXPECT_EQ(attempt_->view().needle, NeedlePlace::Used) << "not touched yet";
  moveBy(*patient.needle().tray() * Vec3{10, 5, 3} - tip(), 10);
  EXPECT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Clean; })) << "touched";
  finish();
  const MetricValues& metrics = attempt_->view().metrics;
  EXPECT_EQ(metrics[Metric::VeinPunctures], 1);
  EXPECT_EQ(metrics[Metric::PosteriorWallPunctures], 0);
  EXPECT_EQ(metrics[Metric::UsedNeedleInsertions], 0);
  using enum AttemptEventKind;
  std::vector<AttemptEventKind> told;  // about the needle; a resting probe may have centered the vein meanwhile
  for (const AttemptEvent& event : attempt_->view().events)
    if (event.kind == Frozen || event.kind == Released || event.kind == NeedleReplaced) told.push_back(event.kind);
  EXPECT_THAT(told, testing::ElementsAre(Frozen, Released, NeedleReplaced));
  hands().assign(kNeedleTool, {});
}

}  // namespace
}  // namespace insonate::train
