#include "NeedleWindow.h"
#include "devices/CameraControl.h"
#include "devices/CameraDialog.h"
#include "devices/DevicePanel.h"
#include "devices/ForceCues.h"
#include "devices/GamepadControl.h"
#include "devices/GamepadDialog.h"

#include <insonate/camera/SimulatedCamera.h>
#include <insonate/ui/Sound.h>

#include <QFileInfo>
#include <QLabel>
#include <QTableWidget>
#include <QTemporaryDir>
#include <cmath>
#include <mutex>

namespace insonate::train {
namespace {

/// Hands that are neither mouse and keys nor haptic devices.
class TrainOtherHands : public NeedleWindow {
 protected:
  DevicePanel& panel() {
    if (!workspace_->findChild<DevicePanel*>()) child<QPushButton>("showDevices")->click();
    return *workspace_->findChild<DevicePanel*>();
  }
  CameraDialog& cameraDialog() {
    panel().showCamera();
    return *panel().findChild<CameraDialog*>();
  }
  QTableWidget& table() { return *panel().findChild<QTableWidget*>("deviceTable"); }
  /// Row of a device by its name; -1: not listed.
  int rowOf(const char* name) {
    for (int row = 0; row < table().rowCount(); ++row)
      if (table().item(row, 0) && table().item(row, 0)->text() == QLatin1String(name)) return row;
    return -1;
  }
  QString cell(const char* name, int column) {
    const int row = rowOf(name);
    return row < 0 || !table().item(row, column) ? QString() : table().item(row, column)->text();
  }
};

/// A folder of frames in which probe and needle lie still, the tools downward.
void renderFrames(const QString& folder) {
  SimulatedSensor sensor;
  sensor.lens = lensWithoutDistortion(640, 480, 68);
  SimulatedCamera camera(sensor, 3);
  const auto still = [](const char* name, double x_mm) {
    const Transform pose{{{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}}, {x_mm, -40, 380}};
    return SimulatedObject{*loadTagBody(name), [pose](double) { return pose; }, {}};
  };
  const CameraFrame frame = camera.render({still("probe", -70), still("needle", 70)}, 0);
  for (int n = 0; n < 6; ++n)
    ASSERT_TRUE(writePgm(frame, folder.toStdString() + "/frame" + std::to_string(n) + ".pgm"));
}

TEST_F(TrainOtherHands, ACameraIsARowPerBodyAndMovesProbeAndNeedle) {
  openWide();
  QTemporaryDir frames;
  renderFrames(frames.path());
  auto& camera = *workspace_->findChild<CameraControl*>();
  EXPECT_EQ(rowOf("Camera: probe"), -1) << "no camera is touched before the user chooses one";
  camera.use(CameraControl::sourceOfFile(frames.path()));
  ASSERT_TRUE(waitFor([&] { return cell("Camera: needle", 1) == "in use"; }))
      << cell("Camera: needle", 1).toStdString();
  EXPECT_TRUE(waitFor([&] { return cell("Camera: needle", 5) == "good"; })) << cell("Camera: needle", 5).toStdString();
  EXPECT_TRUE(waitFor([&] { return cell("Camera: probe", 3).toInt() > 5; }));
  EXPECT_TRUE(cell("Camera: probe", 4).endsWith(" ms"));
  EXPECT_EQ(cell("Camera: probe", 2), "-");
  EXPECT_EQ(cell("Mouse and keys", 2), "probe, needle");

  // The camera moves the needle, the mouse the probe.
  hands().assign(kNeedleTool, "camera:needle");
  ASSERT_TRUE(waitFor([&] { return hands().needle().has_value(); }));
  EXPECT_TRUE(waitFor([&] { return cell("Camera: needle", 2) == "needle"; }));
  EXPECT_EQ(cell("Mouse and keys", 2), "probe");
  EXPECT_EQ(hands().kindOfHand(kNeedleTool), "camera");
  EXPECT_EQ(hands().kindOfHand(kProbeTool), "mouse");
  // The needle begins beside the probe, wherever the user holds the body.
  EXPECT_TRUE(waitFor([&] { return norm(hands().needle()->patientFromNeedle.offset) < 60; }))
      << norm(hands().needle()->patientFromNeedle.offset);

  CameraDialog& dialog = cameraDialog();
  auto* state = dialog.findChild<QLabel*>("cameraState");
  EXPECT_TRUE(waitFor([&] { return state->text().contains("640 × 480"); })) << state->text().toStdString();
  EXPECT_TRUE(dialog.findChild<QLabel*>("needleAdvice")->text().contains("seen well"));
  dialog.print(frames.filePath("hands.pdf"));
  EXPECT_GT(QFileInfo(frames.filePath("hands.pdf")).size(), 1000);
}

TEST_F(TrainOtherHands, TheDeskIsSetInOneGestureAndKept) {
  openWide();
  QTemporaryDir frames;
  renderFrames(frames.path());
  auto& camera = *workspace_->findChild<CameraControl*>();
  camera.use(CameraControl::sourceOfFile(frames.path()));
  hands().assign(kProbeTool, "camera:probe");
  hands().assign(kNeedleTool, "camera:needle");
  const Transform start = model_->motion.pose();
  ASSERT_TRUE(waitFor([&] { return hands().needle().has_value() && hands().drivesProbe(); }));
  cameraDialog().findChild<QPushButton*>("setDesk")->click();
  ASSERT_TRUE(waitFor([&] { return workspace_->statusText().contains("The desk is set"); }))
      << cameraDialog().findChild<QLabel*>("cameraTask")->text().toStdString();
  // The probe is on the outline, so that it is at its start; the needle's tip is 140 mm beside it, as in the frames.
  EXPECT_TRUE(waitFor([&] { return norm(hands().drivenPose().offset - start.offset) < 1; }))
      << norm(hands().drivenPose().offset - start.offset);
  EXPECT_TRUE(waitFor([&] {
    const auto needle = hands().needle();
    return needle && std::abs(norm(needle->patientFromNeedle.offset - start.offset) - norm(Vec3{140, 35, 0})) < 3;
  })) << (hands().needle() ? norm(hands().needle()->patientFromNeedle.offset - start.offset) : -1);
  QSettings settings;
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  auto& restored = *other.findChild<CameraControl*>();
  EXPECT_EQ(restored.source(), camera.source());
  ASSERT_TRUE(restored.hands());
  EXPECT_TRUE(restored.hands()->calibration().cameraFromDesk);
}

/// A controller that the test holds.
struct Pad {
  std::mutex mutex;
  bool isConnected = true;
  GamepadReading held;
  double felt = 0;

  void hold(const GamepadReading& reading) {
    const std::lock_guard lock(mutex);
    held = reading;
  }
  double feel() {
    const std::lock_guard lock(mutex);
    return felt;
  }
};

class PadPort : public GamepadPort {
 public:
  explicit PadPort(std::shared_ptr<Pad> pad) : pad_(std::move(pad)) {}
  Result<void> open() override { return {}; }
  bool read(GamepadReading& reading, std::string&) override {
    const std::lock_guard lock(pad_->mutex);
    reading = pad_->held;
    return pad_->isConnected;
  }
  void rumble(double strength, std::chrono::milliseconds) override {
    const std::lock_guard lock(pad_->mutex);
    pad_->felt = std::max(pad_->felt, strength);
  }

 private:
  std::shared_ptr<Pad> pad_;
};

GamepadReading stick(GamepadAxis axis, double value) {
  GamepadReading reading;
  reading.axes[std::size_t(axis)] = value;
  return reading;
}

TEST_F(TrainOtherHands, AControllerMovesBothToolsAndVibratesAtAPuncture) {
  openWide();
  const auto pad = std::make_shared<Pad>();
  GamepadControl control(*model_, workspace_->commands(), [&] { return std::make_unique<PadPort>(pad); });
  EXPECT_FALSE(control.gamepads()) << "nothing is started before it is needed";
  hands().assign(kProbeTool, "gamepad:left");
  hands().assign(kNeedleTool, "gamepad:right");
  ASSERT_TRUE(control.gamepads());
  EXPECT_EQ(hands().kindOfHand(kProbeTool), "controller");

  const Vec3 before = model_->motion.pose().offset;
  pad->hold(stick(GamepadAxis::LeftX, 1));
  EXPECT_TRUE(waitFor([&] { return norm(model_->motion.pose().offset - before) > 3; }));
  pad->hold({});
  QTest::qWait(100);
  const double rest_mm = model_->motion.numbers().press_mm;
  pad->hold(stick(GamepadAxis::LeftTrigger, 1));
  EXPECT_TRUE(waitFor([&] { return model_->motion.numbers().press_mm > rest_mm + 5; }));
  pad->hold({});
  EXPECT_TRUE(waitFor([&] { return std::abs(model_->motion.numbers().press_mm - rest_mm) < 0.1; }))
      << model_->motion.numbers().press_mm << " after " << rest_mm;
  model_->motion.home();

  GamepadReading take;
  take.buttons = 1U << unsigned(GamepadButton::West);
  pad->hold(take);
  ASSERT_TRUE(waitFor([&] { return hands().needleHand() != nullptr; }));
  pad->hold({});
  hands().needleTo({0, 0, 12});
  type("needle_angle", "90");
  EXPECT_EQ(pad->feel(), 0);
  pad->hold(stick(GamepadAxis::RightTrigger, 1));
  EXPECT_TRUE(waitFor([&] { return lying().depth_mm > 8; })) << lying().depth_mm;
  pad->hold({});
  EXPECT_EQ(pad->feel(), 1) << "the pop of the skin";
  GamepadReading withdraw = stick(GamepadAxis::RightTrigger, 1);
  withdraw.buttons = 1U << unsigned(GamepadButton::RightShoulder);
  pad->hold(withdraw);
  EXPECT_TRUE(waitFor([&] { return !lying().inBody; }));
  hands().assign(kProbeTool, {});
  hands().assign(kNeedleTool, {});
}

TEST_F(TrainOtherHands, ControlsAreRemappedAndKept) {
  openWide();
  auto& control = *workspace_->findChild<GamepadControl*>();
  panel().findChild<QPushButton*>("setController")->click();
  auto& dialog = *panel().findChild<GamepadDialog*>();
  auto* freeze = dialog.findChild<QComboBox*>("control9");
  EXPECT_EQ(freeze->currentText(), "lower button (A)");
  freeze->setCurrentIndex(kGamepadAxes + int(GamepadButton::Start));
  Q_EMIT freeze->activated(freeze->currentIndex());
  GamepadReading start;
  start.buttons = 1U << unsigned(GamepadButton::Start);
  EXPECT_EQ(control.map().valueOf(GamepadFunction::Freeze, start), 1);
  QSettings settings;
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  EXPECT_EQ(other.findChild<GamepadControl*>()->map(), control.map());
  dialog.findChild<QPushButton*>("usualControls")->click();
  EXPECT_EQ(control.map(), GamepadMap());
}

TEST_F(TrainOtherHands, ForcesAreShownAndPuncturesHeard) {
  openWide();
  auto* cues = child<ForceCues>("forceCues");
  EXPECT_FALSE(cues->isVisible()) << "off at first";
  panel().findChild<QCheckBox*>("showForces")->click();
  EXPECT_TRUE(cues->isVisible());
  overTheVein();
  type("needle_depth", "6");
  EXPECT_TRUE(waitFor([&] { return cues->caption() == "puncture"; })) << "of the skin, without sound";
  ASSERT_TRUE(waitFor([&] { return lying().depth_mm > 5; }));
  EXPECT_TRUE(waitFor([&] { return cues->caption().isEmpty(); })) << "for a moment";
  workspace_->sound().setOn(true);
  type("needle_depth", "14");
  EXPECT_TRUE(waitFor([&] { return cues->caption() == "puncture"; }));
  EXPECT_TRUE(waitFor([&] { return cues->caption().isEmpty(); })) << "for a moment";
  workspace_->sound().setOn(false);
  QSettings settings;
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  EXPECT_TRUE(other.findChild<ForceCues*>("forceCues")->isOn());
}

TEST_F(TrainOtherHands, TheFirstAnswerSetsEverythingUp) {
  openWide();
  workspace_->setHands(ui::HandsChoice::Camera);
  EXPECT_EQ(hands().choice().device(kProbeTool), "camera:probe");
  EXPECT_EQ(hands().choice().device(kNeedleTool), "camera:needle");
  EXPECT_TRUE(panel().findChild<CameraDialog*>()->isVisible());
  workspace_->setHands(ui::HandsChoice::Mouse);
  EXPECT_EQ(hands().choice().device(kProbeTool), "");
  EXPECT_EQ(hands().choice().device(kNeedleTool), "");
}

TEST_F(TrainOtherHands, EveryRowHasATest) {
  openWide();
  overTheVein();
  ASSERT_TRUE(waitFor([&] { return table().cellWidget(0, 7) && hands().needle(); }));
  qobject_cast<QPushButton*>(table().cellWidget(0, 7))->click();
  auto* events = panel().findChild<QListWidget*>("deviceEvents");
  EXPECT_TRUE(events->item(0)->text().contains("Mouse and keys: move it"));
  type("needle_angle", "60");
  EXPECT_TRUE(waitFor([&] { return events->item(0)->text().contains("updates per second"); }))
      << events->item(0)->text().toStdString();
}

}  // namespace
}  // namespace insonate::train
