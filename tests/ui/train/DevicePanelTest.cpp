#include "NeedleWindow.h"
#include "devices/DeviceList.h"
#include "devices/DevicePanel.h"
#include "devices/HandPlots.h"
#include "devices/HandSection.h"

#include <insonate/haptics/SimulatedDevice.h>

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QTableWidget>
#include <QTemporaryDir>
#include <atomic>
#include <chrono>

namespace insonate::train {
namespace {

class TrainDevices : public NeedleWindow {
 protected:
  DevicePanel& panel() {
    if (!workspace_->findChild<DevicePanel*>()) child<QPushButton>("showDevices")->click();
    return *workspace_->findChild<DevicePanel*>();
  }
  template <class T>
  T& in(const char* section, const char* name) {
    T* found = panel().findChild<HandSection*>(section)->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return *found;
  }
  void addSimulated(int profile) {
    panel().findChild<QPushButton*>("addSimulated")->menu()->actions().at(profile)->trigger();
  }
  void choose(QComboBox& combo, const QString& data) {
    combo.setCurrentIndex(combo.findData(data));
    ASSERT_GE(combo.currentIndex(), 0) << data.toStdString();
    Q_EMIT combo.activated(combo.currentIndex());
  }
  SimulatedDevice& simulated(const char* id) {
    return dynamic_cast<SimulatedDevice&>(*hands().deviceOf(QLatin1String(id)));
  }
  ServoSnapshot now() { return hands().session().snapshot(); }
};

TEST_F(TrainDevices, SimulatedDevicesAreListedAndHoldProbeAndNeedle) {
  openWide();
  auto* table = panel().findChild<QTableWidget*>("deviceTable");
  const int before = table->rowCount();
  auto* none = panel().findChild<QLabel*>("noDevices");
  EXPECT_EQ(table->item(0, 0)->text(), "Mouse and keys");
  EXPECT_EQ(none->isVisible(), before == 1) << "says what to do if there is no other device";
  addSimulated(0);
  addSimulated(3);
  EXPECT_TRUE(waitFor([&] { return table->rowCount() == before + 2; }));
  EXPECT_FALSE(none->isVisible());
  choose(in<QComboBox>("probeHand", "device"), "simulated:omega#2");
  choose(in<QComboBox>("needleHand", "device"), "simulated:Touch#1");
  EXPECT_TRUE(waitFor([&] { return now().present[kProbeTool]; }));
  EXPECT_FALSE(hands().needle()) << "until it is taken up";
  EXPECT_TRUE(in<QLabel>("needleHand", "state").text().contains("no needle") ||
              waitFor([&] { return !in<QLabel>("needleHand", "state").text().isEmpty(); }));
  // Mouse and keys lead the hand; the image follows the device.
  model_->motion.typed(HandAxis::Press, 4);
  EXPECT_TRUE(waitFor([&] { return model_->live.shown()->press.force_N > 0.2 && now().output.skinForce_N > 0.2; }));
  EXPECT_TRUE(waitFor([&] { return in<QLabel>("probeHand", "force").text().contains(" N"); }));
  EXPECT_LT(model_->motion.pose().offset.y, 4) << "the skin pushes the hand back";
  auto* plots = panel().findChild<HandPlots*>("handPlots");
  EXPECT_TRUE(waitFor([&] { return plots->points() > 5; }));
  EXPECT_TRUE(waitFor([&] { return in<QLabel>("probeHand", "state").text().contains("in use"); }));
}

TEST_F(TrainDevices, UnpluggedInContactItIsSaidAndNothingPushes) {
  openWide();
  panel();
  addSimulated(0);
  choose(in<QComboBox>("needleHand", "device"), "simulated:Touch#1");
  overTheVein();
  type("needle_depth", "6");
  ASSERT_TRUE(waitFor([&] { return norm(now().output.tools[kNeedleTool].force.force_N) > 0.2; }));
  simulated("simulated:Touch#1").setConnected(false);
  ASSERT_TRUE(waitFor([&] { return !now().present[kNeedleTool]; }));
  EXPECT_EQ(norm(now().output.tools[kNeedleTool].force.force_N), 0);
  EXPECT_TRUE(waitFor([&] { return in<QLabel>("needleHand", "state").text().contains("unplugged"); }))
      << in<QLabel>("needleHand", "state").text().toStdString();
  EXPECT_TRUE(waitFor([&] { return !in<QLabel>("needleHand", "force").isVisible(); }));
  simulated("simulated:Touch#1").setConnected(true);
  EXPECT_TRUE(waitFor([&] { return in<QLabel>("needleHand", "state").text().contains("in use"); }));
}

TEST_F(TrainDevices, WhatIsSetForADeviceIsKept) {
  openWide();
  panel();
  addSimulated(1);
  choose(in<QComboBox>("needleHand", "device"), "simulated:Desktop#1");
  in<ui::ValueSlider>("needleHand", "gain").setValue(50);
  in<ui::ValueSlider>("needleHand", "mostForce").setValue(1.5);
  auto& stand = in<QComboBox>("needleHand", "stand");
  stand.setCurrentIndex(2);
  Q_EMIT stand.activated(2);
  auto& up = in<QLineEdit>("needleHand", "apart1");
  up.setFocus();
  up.selectAll();
  QTest::keyClicks(&up, "80");
  QTest::keyClick(&up, Qt::Key_Return);
  key(Qt::Key_I);
  const ToolSetup used = hands().session().setupOf(kNeedleTool);
  EXPECT_EQ(used.gain, 0.5);
  EXPECT_EQ(used.userMaxForce_N, 1.5);
  EXPECT_EQ(used.apart_mm, (Vec3{0, 80, 0}));
  QSettings settings;
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  const HapticControl& restored = other.findChild<TrainModel*>()->hands;
  EXPECT_EQ(restored.choice().device(kNeedleTool), "simulated:Desktop#1");
  EXPECT_EQ(restored.choice().device(kProbeTool), QString());
  const HandMapping mapping = restored.choice().mapping("simulated:Desktop#1");
  EXPECT_EQ(mapping.gain, 0.5);
  EXPECT_EQ(mapping.userMaxForce_N, 1.5);
  EXPECT_EQ(mapping.stand, Stand::Left);
  EXPECT_EQ(mapping.apart_mm, (Vec3{0, 80, 0}));
}

TEST_F(TrainDevices, ATestForceTakesTheDeviceForASecond) {
  openWide();
  panel();
  addSimulated(0);
  choose(in<QComboBox>("probeHand", "device"), "simulated:Touch#1");
  ASSERT_TRUE(waitFor([&] { return now().present[kProbeTool]; }));
  in<QPushButton>("probeHand", "testForce").click();
  EXPECT_TRUE(waitFor([&] { return !now().present[kProbeTool]; }));
  EXPECT_TRUE(waitFor([&] { return now().present[kProbeTool]; }));
}

TEST_F(TrainDevices, BeginHerePutsTheToolAtItsStart) {
  openWide();
  panel();
  addSimulated(1);
  choose(in<QComboBox>("probeHand", "device"), "simulated:Desktop#1");
  ASSERT_TRUE(waitFor([&] { return now().present[kProbeTool]; }));
  simulated("simulated:Desktop#1").setTarget({0, {30, 10, 0}, {}});
  ASSERT_TRUE(waitFor([&] { return norm(now().states[kProbeTool].deviceFromStylus.offset - Vec3{30, 10, 0}) < 1; }));
  ASSERT_TRUE(waitFor([&] { return norm(model_->motion.pose().offset) > 20; }));
  in<QPushButton>("probeHand", "beginHere").click();
  EXPECT_TRUE(waitFor([&] { return norm(model_->motion.pose().offset) < 1.5; })) << norm(model_->motion.pose().offset);
}

/// A pedal that the test steps on.
class Pedal : public HapticDevice {
 public:
  Pedal() { info_.id = "test:pedal", info_.name = "Test pedal", info_.kind = DeviceKind::kPedal; }
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return DevicePhase::kStreaming; }
  std::string error() const override { return {}; }
  DeviceCounters counters() const noexcept override { return {}; }
  bool pollState(DeviceState& state) noexcept override {
    state.buttons = down, state.time_ns = 1;
    return true;
  }
  void push(const Force&) noexcept override {}
  std::atomic<std::uint32_t> down = 0;

 private:
  DeviceInfo info_;
};

TEST_F(TrainDevices, APedalFreezesAndMakesLiveAgain) {
  openWide();
  const auto pedal = std::make_shared<Pedal>();
  hands().session().devices().add(pedal);
  panel();
  QComboBox& combo = *panel().findChild<QComboBox*>("pedal");
  ASSERT_TRUE(waitFor([&] { return combo.findData("test:pedal") >= 0; }));
  choose(combo, "test:pedal");
  QTest::qWait(100);
  EXPECT_FALSE(model_->live.isFrozen());
  for (const bool frozen : {true, false}) {
    pedal->down = 1;
    EXPECT_TRUE(waitFor([&] { return model_->live.isFrozen() == frozen; }));
    QTest::qWait(100);
    EXPECT_EQ(model_->live.isFrozen(), frozen) << "once a step";
    pedal->down = 0;
    QTest::qWait(100);
  }
}

TEST_F(TrainDevices, RecordingsAreWrittenAndWhatCannotBeIsSaid) {
  openWide();
  QTemporaryDir folder;
  DeviceList& list = panel().list();
  auto* events = panel().findChild<QListWidget*>("deviceEvents");
  const std::filesystem::path file = folder.filePath("reports.txt").toStdString();
  EXPECT_TRUE(list.record(file));
  EXPECT_TRUE(list.record({}));
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(list.record(folder.filePath("not/there/reports.txt").toStdString()));
  EXPECT_FALSE(events->item(0)->icon().isNull());
  list.replay(file);
  EXPECT_FALSE(events->item(0)->icon().isNull()) << "a recording of no device";
}

TEST_F(TrainDevices, ClosesWhileBothHandsAreFull) {
  openWide();
  panel();
  addSimulated(0);
  addSimulated(1);
  choose(in<QComboBox>("probeHand", "device"), "simulated:Desktop#2");
  choose(in<QComboBox>("needleHand", "device"), "simulated:Touch#1");
  overTheVein();
  type("needle_depth", "20");
  model_->motion.typed(HandAxis::Press, 5);
  QTest::qWait(300);
  workspace_ = nullptr;
  QTest::qWait(50);
}

}  // namespace
}  // namespace insonate::train
