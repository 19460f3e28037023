#include "AttemptWindow.h"
#include "Stylus.h"
#include "line/LineStrip.h"
#include "line/WireHand.h"

#include <insonate/ui/ViewWidget.h>

#include <gmock/gmock.h>

#include <QMenu>

namespace insonate::train {
namespace {

/// A line in the vein of a block of tissue, by mouse and keys.
class TrainLine : public AttemptWindow {
 protected:
  void openWithNames() {
    static const auto named = [] {
      PatientCase made = wideCase();
      NamedVessel vein{.name = "right internal jugular vein", .label = kVein, .course = {}};
      for (int z = 25; z >= -25; z -= 5) vein.course.push_back({{0, 12, double(z)}, 4.5});
      made.manifest.vessels = {vein};
      made.manifest.targets = {{"right internal jugular vein", kVein, {0, 12, 0}}};
      return std::make_shared<const PatientCase>(std::move(made));
    }();
    open(named);
  }
  void choose(const char* procedure) {
    auto* list = child<QComboBox>("attemptProcedure");
    const int index = list->findData(procedure);
    ASSERT_GE(index, 0);
    list->setCurrentIndex(index);
    Q_EMIT list->activated(index);
  }
  /// Chooses an entry of the menu of acts, as a click does.
  void perform(const QString& title) {
    auto* menu = child<QPushButton>("lineActs")->menu();
    Q_EMIT menu->aboutToShow();
    for (QAction* action : menu->actions())
      if (action->text() == title) {
        ASSERT_TRUE(action->isEnabled()) << title.toStdString();
        return action->trigger();
      }
    FAIL() << title.toStdString() << " is not in the menu";
  }
  void puncture() {
    key(Qt::Key_I);
    hands().needleTo({0, 0, 12});
    type("needle_angle", "45");
    type("needle_heading", "180");
    type("needle_depth", "17");
    ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  }
  const LineState& line() { return attempt_->view().line; }
};

TEST_F(TrainLine, TheStripIsThereOnlyForAProcedureWithALine) {
  openWithNames();
  start();
  EXPECT_FALSE(shown("lineStrip"));
  finish();
  key(Qt::Key_Escape);
  attempt_->leave();
  choose("internal_jugular_line");
  start();
  EXPECT_TRUE(shown("lineStrip"));
  EXPECT_TRUE(shown("monitorStrip"));
  EXPECT_TRUE(waitFor([&] { return text("monitorRate") == "HR 70"; })) << text("monitorRate").toStdString();
  EXPECT_EQ(text("monitorPressure"), "120/80");
  EXPECT_FALSE(shown("monitorRhythm")) << "the rhythm is normal";
  EXPECT_TRUE(text("attemptDue").contains("Check indication and consent")) << text("attemptDue").toStdString();
  perform("Check indication and consent");
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("time-out"); })) << text("attemptDue").toStdString();
}

TEST_F(TrainLine, TheMonitorLeavesWithTheAttemptUnderAMaximizedView) {
  openWithNames();
  choose("internal_jugular_line");
  start();
  ASSERT_TRUE(shown("monitorStrip"));
  auto* scene = child<ui::ViewWidget>("sceneView");
  scene->setMaximized(true);
  EXPECT_FALSE(shown("monitorStrip"));
  finish();
  attempt_->leave();
  scene->setMaximized(false);
  EXPECT_TRUE(waitFor([&] { return !shown("monitorStrip"); }));
}

TEST_F(TrainLine, TheWireGoesThroughTheNeedleByKeys) {
  openWithNames();
  choose("internal_jugular_line");
  start();
  puncture();
  key(Qt::Key_PageDown, Qt::ControlModifier);
  EXPECT_TRUE(workspace_->statusText().contains("The syringe is on the needle"))
      << workspace_->statusText().toStdString();
  perform("Detach syringe");
  ASSERT_TRUE(waitFor([&] { return !line().isSyringeOn; }));
  EXPECT_TRUE(waitFor([&] { return text("attemptDrawn") == "syringe detached"; }))
      << text("attemptDrawn").toStdString();
  perform("Measure pressure");
  EXPECT_TRUE(workspace_->statusText().contains("mmHg")) << workspace_->statusText().toStdString();
  for (int i = 0; i < 4; ++i) key(Qt::Key_PageDown, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return line().wireIn == kVein; })) << workspace_->statusText().toStdString();
  EXPECT_TRUE(line().isWireHeld);
  EXPECT_TRUE(text("lineDepth").endsWith(" mm")) << text("lineDepth").toStdString();
  ASSERT_TRUE(waitFor([&] {
    const auto frame = model_->live.shown();
    return frame && frame->rods && !frame->rods->empty();
  })) << "the image has the wire";

  // By the stated anatomy beyond the block, the heart is up to 25 cm away.
  for (int i = 0; i < 12 && line().rhythm == HeartRhythm::Sinus; ++i) {
    key(Qt::Key_PageDown, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::qWait(300);
  }
  ASSERT_EQ(line().rhythm, HeartRhythm::ExtraBeats) << line().wire_mm;
  EXPECT_TRUE(waitFor([&] { return shown("monitorRhythm"); }));
  EXPECT_EQ(text("monitorRhythm"), "Extra beats");
  for (int i = 0; i < 3; ++i) key(Qt::Key_PageUp, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(waitFor([&] { return line().rhythm == HeartRhythm::Sinus && !shown("monitorRhythm"); }));

  type("needle_depth", "-5");
  ASSERT_TRUE(waitFor([&] { return !line().isNeedleInBody; }));
  EXPECT_TRUE(line().isWireIn()) << "held, it stays";
  key(Qt::Key_R);
  EXPECT_EQ(child<QComboBox>("lineInstrument")->currentText(), "Dilator");
  key(Qt::Key_PageDown, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(workspace_->statusText().contains("Nick the skin")) << workspace_->statusText().toStdString();
  finish();
  EXPECT_FALSE(shown("lineStrip"));
  const auto recording = recorded();
  ASSERT_TRUE(recording) << recording.error().message;
  const auto values = recording->metricsUntil();
  ASSERT_TRUE(values);
  EXPECT_GT(*(*values)[Metric::WireDepth], 17);
  EXPECT_EQ((*values)[Metric::CatheterInVein], 0);
  const auto settings = recording->settingsAt(recording->end_us());
  ASSERT_TRUE(settings);
  EXPECT_NE(settings->find("\"rods\""), std::string::npos) << "a replay shows the wire";
}

/// The second button grips the wire, and the wire goes as far as the hand.
TEST_F(TrainLine, ADeviceMovesTheWireThatItsHandGrips) {
  openWithNames();
  choose("internal_jugular_line");
  start();
  puncture();
  perform("Detach syringe");
  for (int i = 0; i < 4; ++i) key(Qt::Key_PageDown, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return line().wireIn == kVein; }));
  type("needle_depth", "-5");
  ASSERT_TRUE(waitFor([&] { return !line().isNeedleInBody; }));

  const auto stylus = std::make_shared<Stylus>();
  hands().session().devices().add(stylus);
  hands().assign(kNeedleTool, "stylus");
  ASSERT_TRUE(waitFor([&] { return child<QComboBox>("lineInstrument")->currentText() == "Needle"; }));
  key(Qt::Key_R);
  ASSERT_EQ(child<QComboBox>("lineInstrument")->currentText(), "Wire");
  QTest::qWait(200);
  const double before_mm = line().wire_mm;
  const Vec3 needle_mm = hands().needle()->patientFromNeedle.offset;
  const Transform& device = hands().session().setupOf(kNeedleTool).patientFromDevice;
  const Vec3 axis = transposed(device.linear) * hands().needle()->patientFromNeedle.linear.column[2];
  const auto moveTo = [&](double along_mm) {
    stylus->x_mm = axis.x * along_mm, stylus->y_mm = axis.y * along_mm, stylus->z_mm = axis.z * along_mm;
    QTest::qWait(300);
  };
  moveTo(-5);
  EXPECT_NEAR(line().wire_mm, before_mm, 0.01) << "a hand without a grip moves freely";
  stylus->buttons = 2;
  QTest::qWait(300);
  for (int i = 0; i <= 6; ++i) moveTo(-5 + i);
  EXPECT_TRUE(waitFor([&] { return line().wire_mm > before_mm + 5; })) << line().wire_mm - before_mm;
  EXPECT_NEAR(line().wire_mm, before_mm + 6, 0.6);
  EXPECT_FALSE(attempt_->isAspirating());
  EXPECT_LT(norm(hands().needle()->patientFromNeedle.offset - needle_mm), 0.1) << "the needle stays";
}

/// A hand that pushes against a stop and comes back does not draw the instrument back before it is behind it.
TEST(GrippedWayOfAHand, AStopIsNotPulledBack) {
  GrippedWay way;
  EXPECT_EQ(way.dueFor(0.3), 0) << "a hand at rest";
  EXPECT_EQ(way.dueFor(3), 3);
  way.moved(3, 3);
  EXPECT_EQ(way.gone_mm(), 3);
  EXPECT_EQ(way.dueFor(6), 3);
  way.moved(3, 1);
  EXPECT_EQ(way.gone_mm(), 4) << "a part of the way";
  EXPECT_EQ(way.dueFor(6), 0) << "each push counts once";
  EXPECT_EQ(way.dueFor(5), 0) << "the hand comes back";
  EXPECT_EQ(way.dueFor(3), -1);
  way.moved(-1, -1);
  EXPECT_EQ(way.dueFor(5), 2) << "and pushes again";
}

TEST_F(TrainLine, ACaseWithoutNamesSaysWhyThereIsNoWire) {
  openWide();
  choose("internal_jugular_line");
  EXPECT_TRUE(text("attemptUnfit").contains("the case names no vein")) << text("attemptUnfit").toStdString();
  key(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_FALSE(attempt_->isBusy());
}

}  // namespace
}  // namespace insonate::train
