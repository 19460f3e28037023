#include "TrainWindow.h"

#include <insonate/simulator/NeedlePlacement.h>
#include <insonate/ui/Commands.h>

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QToolButton>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace insonate::train {
namespace {

/// The commands of the workspace: their keys, and the list of keys that is made from them.
class TrainCommands : public TrainWindow {
 protected:
  const std::vector<ui::Command>& all() { return workspace_->commands().all(); }

  /// Tells whether a key has a command that is available now.
  bool isTaken(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    return workspace_->commands().key(QKeyEvent(QEvent::KeyPress, key, modifiers), false);
  }

  /// Id of the command of a key; empty without one.
  std::string idOf(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    for (const ui::Command& command : all())
      for (const ui::CommandKey& one : command.keys)
        if (one.key == key && one.modifiers == modifiers) return command.id.toStdString();
    return {};
  }

  using Numbers = std::array<double, 6>;
  Numbers probe() {
    const HandNumbers now = model_->motion.numbers();
    return {now.skin_mm.x, now.skin_mm.z, now.rotation_deg, now.tilt_deg, now.rock_deg, now.press_mm};
  }
  Numbers needle() {
    const NeedlePlacement* hand = model_->hands.needleHand();
    if (!hand) return {};
    const NeedlePlacementState state = hand->state();
    return {state.entry_mm.x, state.entry_mm.z, hand->heading_deg(),
            state.angle_deg,  state.bevel_deg,  model_->hands.wantedAdvance_mm()};
  }
  static double distance(const Numbers& a, const Numbers& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  }

  template <class Read>
  void expectOpposite(Qt::Key one, Qt::Key other, Qt::KeyboardModifiers modifiers, double step, Read read) {
    SCOPED_TRACE(QKeySequence(int(modifiers) | one).toString().toStdString());
    EXPECT_EQ(idOf(one, modifiers & ~Qt::ShiftModifier), idOf(other, modifiers & ~Qt::ShiftModifier));
    const Numbers before = read();
    key(one, modifiers);
    EXPECT_NEAR(distance(before, read()), step, 0.05);
    key(other, modifiers);
    EXPECT_NEAR(distance(before, read()), 0, 0.05);
  }
};

TEST_F(TrainCommands, NoToolTipNamesACommandThatHasNoKeys) {
  int tips = 0;
  for (const auto* widget : workspace_->findChildren<QWidget*>()) {
    EXPECT_FALSE(widget->toolTip().contains("()"))
        << widget->objectName().toStdString() << ": " << widget->toolTip().toStdString();
    tips += !widget->toolTip().isEmpty();
  }
  EXPECT_GT(tips, 50);
}

TEST_F(TrainCommands, IdsAndKeysAreUnique) {
  std::set<QString> ids;
  std::set<std::pair<int, int>> taken;
  for (const ui::Command& command : all()) {
    EXPECT_TRUE(command.id.startsWith("train.") && command.id.count('.') == 2) << command.id.toStdString();
    EXPECT_TRUE(ids.insert(command.id).second) << command.id.toStdString();
    for (const ui::CommandKey& one : command.keys) {
      EXPECT_TRUE(taken.emplace(one.key, int(one.modifiers)).second) << command.id.toStdString();
      EXPECT_TRUE(one.perform || command.perform) << command.id.toStdString();
    }
  }
  EXPECT_GE(taken.size(), 68U) << "as many as ever";
}

TEST_F(TrainCommands, WhatIsListedIsExplained) {
  for (const ui::Command& command : all()) {
    SCOPED_TRACE(command.id.toStdString());
    EXPECT_FALSE(command.does.isEmpty());
    EXPECT_EQ(command.listed.isEmpty(), command.keys.empty()) << "each key is listed, and nothing else";
    // Those in words: "Arrows", "1 to 9".
    static const std::set<QString> kInWords{"train.probe.slide", "train.needle.entry", "train.probe.recall",
                                            "train.patient3d.window"};
    if (command.keys.empty() || kInWords.contains(command.id)) continue;
    const ui::CommandKey& first = command.keys.front();
    static const std::map<int, QString> kNamed{
        {Qt::Key_PageDown, "Page Down"}, {Qt::Key_Comma, "Comma"}, {Qt::Key_Delete, "Delete"}};
    const auto named = kNamed.find(first.key);
    const QString control = first.modifiers & Qt::ControlModifier ? QStringLiteral("Ctrl+") : QString();
    const QString name =
        named != kNamed.end() ? control + named->second : QKeySequence(int(first.modifiers) | first.key).toString();
    EXPECT_TRUE(command.listed.startsWith(name)) << command.listed.toStdString() << ", not " << name.toStdString();
  }
}

TEST_F(TrainCommands, TheListBeginsWithWhatIsNeededFirst) {
  QStringList places, said;
  for (const ui::ShortcutGroup& section : workspace_->commands().shortcuts()) {
    places << section.place;
    for (const ui::Shortcut& one : section.shortcuts) {
      EXPECT_FALSE(one.keys.isEmpty() || one.does.isEmpty()) << section.place.toStdString();
      EXPECT_FALSE(said.contains(one.keys)) << one.keys.toStdString() << " is listed twice";
      said << one.keys;
    }
  }
  EXPECT_EQ(places.join(", ").toStdString(),
            "Probe, Needle, Image, Attempts, Measurements, Patient in 3D and CT, Tissue, Undo");
  EXPECT_EQ(said.value(0).toStdString(), "Arrows");
  EXPECT_TRUE(said.contains("Left drag on the image")) << "mouse gestures, too";
}

TEST_F(TrainCommands, ControlAndAltMakeOtherKeys) {
  EXPECT_EQ(idOf(Qt::Key_S), "train.probe.tilt");
  EXPECT_EQ(idOf(Qt::Key_S, Qt::ControlModifier), "") << "saves the case, in every workspace";
  EXPECT_EQ(idOf(Qt::Key_S, Qt::AltModifier), "train.needle.angle") << "Alt is the needle";
  EXPECT_EQ(idOf(Qt::Key_Left, Qt::AltModifier), "train.needle.entry");
  EXPECT_EQ(idOf(Qt::Key_P), "train.tissue.pressure");
  EXPECT_EQ(idOf(Qt::Key_P, Qt::ControlModifier), "train.image.save");
  EXPECT_EQ(idOf(Qt::Key_Z, Qt::ControlModifier), "train.undo.undo");
  EXPECT_EQ(idOf(Qt::Key_F, Qt::ControlModifier), "");
  EXPECT_EQ(idOf(Qt::Key_I, Qt::AltModifier), "");
  EXPECT_EQ(idOf(Qt::Key_1), "train.probe.recall");
  EXPECT_EQ(idOf(Qt::Key_1, Qt::AltModifier), "train.patient3d.window");
}

TEST_F(TrainCommands, WithoutAPatientOnlyWhatNeedsNoneIsAvailable) {
  std::set<QString> available;
  for (const ui::Command& command : all())
    if (!command.isAvailable || command.isAvailable()) available.insert(command.id);
  EXPECT_EQ(available, (std::set<QString>{"train.devices.show", "train.layout.leftHanded", "train.levels.show",
                                          "train.link.trackers", "train.undo.undo", "train.undo.redo"}));
  key(Qt::Key_Space);
  EXPECT_FALSE(model_->live.isFrozen());
}

TEST_F(TrainCommands, APageInPlaceOfTheImageLeavesTheKeysToIt) {
  openCase();
  EXPECT_TRUE(isTaken(Qt::Key_Left) && isTaken(Qt::Key_Z) && isTaken(Qt::Key_Space));
  key(Qt::Key_J);
  EXPECT_FALSE(isTaken(Qt::Key_Left) || isTaken(Qt::Key_Z) || isTaken(Qt::Key_Space));
  EXPECT_TRUE(isTaken(Qt::Key_J));
  QTest::keyClick(workspace_.get(), Qt::Key_J);
  EXPECT_TRUE(isTaken(Qt::Key_Left));
}

TEST_F(TrainCommands, EscapeIsTakenOnlyWhileMeasuring) {
  openCase();
  EXPECT_FALSE(isTaken(Qt::Key_Escape));
  key(Qt::Key_L);
  EXPECT_TRUE(isTaken(Qt::Key_Escape));
  key(Qt::Key_Escape);
  EXPECT_FALSE(isTaken(Qt::Key_Escape));
}

TEST_F(TrainCommands, OppositeKeysOfTheProbeUndoEachOther) {
  openCase();
  const auto read = [this] { return probe(); };
  const struct {
    Qt::Key one, other;
    double step, wide;
  } pairs[] = {{Qt::Key_Left, Qt::Key_Right, 1, 5}, {Qt::Key_Up, Qt::Key_Down, 1, 5},
               {Qt::Key_Q, Qt::Key_E, 2, 10},       {Qt::Key_W, Qt::Key_S, 1, 5},
               {Qt::Key_A, Qt::Key_D, 1, 5},        {Qt::Key_Plus, Qt::Key_Minus, 0.5, 0.5}};
  for (const auto& one : pairs) {
    expectOpposite(one.one, one.other, Qt::NoModifier, one.step, read);
    expectOpposite(one.one, one.other, Qt::ShiftModifier, one.wide, read);
  }
}

TEST_F(TrainCommands, OppositeKeysOfTheNeedleUndoEachOther) {
  openCase();
  settle();
  key(Qt::Key_I);
  ASSERT_TRUE(model_->hands.needleHand());
  const auto read = [this] { return needle(); };
  const struct {
    Qt::Key one, other;
    double step;
  } pairs[] = {{Qt::Key_Right, Qt::Key_Left, 1},
               {Qt::Key_Up, Qt::Key_Down, 1},
               {Qt::Key_Q, Qt::Key_E, 2},
               {Qt::Key_W, Qt::Key_S, 1},
               {Qt::Key_A, Qt::Key_D, 10}};
  for (const auto& one : pairs) expectOpposite(one.one, one.other, Qt::AltModifier, one.step, read);
  expectOpposite(Qt::Key_PageDown, Qt::Key_PageUp, Qt::NoModifier, 1, read);
  key(Qt::Key_I);
  EXPECT_FALSE(model_->hands.needleHand());
}

TEST_F(TrainCommands, NumberKeysRecallPositionsInTheirOrder) {
  openCase();
  key(Qt::Key_Right, Qt::ShiftModifier);
  child<QPushButton>("savePosition")->click();
  auto* list = child<QListWidget>("positions");
  ASSERT_EQ(list->count(), 2);
  for (const int place : {0, 1, 0}) {
    key(Qt::Key(Qt::Key_1 + place));
    EXPECT_EQ(list->currentRow(), place);
    EXPECT_NEAR(model_->motion.numbers().skin_mm.x, place * 5, 0.1);
  }
  key(Qt::Key_9);
  EXPECT_EQ(list->currentRow(), 0) << "there is no ninth position";
}

TEST_F(TrainCommands, TooltipsAndMenusSayTheKeysOfTheCommands) {
  const auto& commands = workspace_->commands();
  EXPECT_EQ(child<QPushButton>("freeze")->toolTip().toStdString(), "Freezes or unfreezes the image (Space, F)");
  const std::pair<const char*, const char*> same[] = {{"ctBesideButton", "train.image.ctBeside"},
                                                      {"attemptDraw", "train.attempt.aspirate"},
                                                      {"attemptNewNeedle", "train.attempt.newNeedle"},
                                                      {"levelsOpen", "train.levels.show"}};
  for (const auto& [object, id] : same)
    EXPECT_EQ(child<QPushButton>(object)->toolTip().toStdString(), commands.toolTip(id).toStdString()) << object;
  EXPECT_EQ(child<QToolButton>("allSlicesTab")->toolTip(), commands.toolTip("train.patient3d.allSlices"));
  for (const char* object : {"attemptStart", "attemptFinish"})
    EXPECT_TRUE(child<QPushButton>(object)->toolTip().endsWith(" (Ctrl+Return)")) << object;
  EXPECT_TRUE(child<QPushButton>("needleAlong")->toolTip().endsWith(" (I)"));
  EXPECT_TRUE(child<QLineEdit>("needle_angle")->toolTip().contains("(Alt+W, Alt+S)"));
  EXPECT_TRUE(child<QPushButton>("save")->toolTip().contains("(Ctrl+P)"));
  EXPECT_TRUE(child<QPushButton>("tissueMenu")->toolTip().contains("(T)"));
  EXPECT_TRUE(child<QComboBox>("effect")->toolTip().contains("only one of them (N, Shift+N)"));
  QStringList entries;
  for (const QAction* action : workspace_->actions()) entries << action->text();
  EXPECT_EQ(entries.join(", ").toStdString(),
            "Trackers ..., Send Images by OpenIGTLink, Names of structures\tCtrl+N, CT beside the image\tC, "
            "Left-handed layout, Devices ..., "
            "Levels and attempts\tJ, Aim line\tCtrl+G");
  QStringList windows;
  for (const QAction* action : child<QToolButton>("sliceMenu")->menu()->actions()) windows << action->text();
  EXPECT_TRUE(windows.contains("soft tissue\tAlt+1") && windows.contains("brain\tAlt+5"));
}

TEST_F(TrainCommands, TheCheckMarkOfAViewEntryFollowsWhatItSwitches) {
  QAction* beside = workspace_->commands().action("train.image.ctBeside");
  QAction* levels = workspace_->commands().action("train.levels.show");
  QAction* leftHanded = workspace_->commands().action("train.layout.leftHanded");
  EXPECT_TRUE(beside->isCheckable() && levels->isCheckable() && leftHanded->isCheckable());
  beside->trigger();
  EXPECT_FALSE(beside->isChecked()) << "there is no patient";
  openCase();
  beside->trigger();
  EXPECT_TRUE(beside->isChecked() && child<QPushButton>("ctBesideButton")->isChecked());
  key(Qt::Key_C);
  EXPECT_FALSE(beside->isChecked());
  key(Qt::Key_J);
  EXPECT_TRUE(levels->isChecked());
  QTest::keyClick(child<QWidget>("course"), Qt::Key_J);
  EXPECT_FALSE(levels->isChecked()) << "the page leaves the key to the command";
  levels->trigger();
  EXPECT_TRUE(levels->isChecked() && child<QWidget>("course")->isVisible());
  QTest::keyClick(child<QWidget>("course"), Qt::Key_Escape);
  EXPECT_FALSE(levels->isChecked());
  leftHanded->trigger();
  EXPECT_TRUE(leftHanded->isChecked());
  leftHanded->trigger();
  EXPECT_FALSE(leftHanded->isChecked());
}

TEST_F(TrainCommands, TheMeasureMenuShowsTheSelectedCaliper) {
  openCase();
  auto* button = child<QPushButton>("measure");
  const QList<QAction*> entries = button->menu()->actions();
  ASSERT_GE(entries.size(), 3);
  EXPECT_EQ(entries[0]->text().toStdString(), "Distance\tL");
  entries[0]->trigger();
  EXPECT_TRUE(entries[0]->isChecked());
  EXPECT_EQ(button->text().toStdString(), "Distance");
  key(Qt::Key_V);
  EXPECT_TRUE(!entries[0]->isChecked() && entries[2]->isChecked());
  EXPECT_EQ(button->text().toStdString(), "Angle");
  entries[2]->trigger();
  EXPECT_FALSE(entries[2]->isChecked()) << "a selected caliper is deselected by selecting it again";
  EXPECT_EQ(button->text().toStdString(), "Measure");
  entries[1]->trigger();
  key(Qt::Key_J);
  entries[0]->trigger();
  EXPECT_TRUE(entries[1]->isChecked() && !entries[0]->isChecked()) << "a page covers the image";
}

TEST_F(TrainCommands, KeysOfAViewTakePrecedenceOverTheWindowsShortcuts) {
  openCase();
  const auto takes = [](QWidget* canvas, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QKeyEvent asked(QEvent::ShortcutOverride, key, modifiers);
    asked.ignore();
    QApplication::sendEvent(canvas, &asked);
    return asked.isAccepted();
  };
  EXPECT_TRUE(takes(canvas_, Qt::Key_A) && takes(canvas_, Qt::Key_P, Qt::ControlModifier));
  EXPECT_FALSE(takes(canvas_, Qt::Key_S, Qt::ControlModifier)) << "saves the case, in every workspace";
  EXPECT_FALSE(takes(canvas_, Qt::Key_G));
  EXPECT_FALSE(takes(canvas_, Qt::Key_Escape));
  for (auto* view : workspace_->findChildren<ui::ViewWidget*>()) {
    if (view->accessibleName() != "CT slice") continue;
    EXPECT_TRUE(takes(view->focusProxy(), Qt::Key_G)) << "the slice's own";
    EXPECT_TRUE(takes(view->focusProxy(), Qt::Key_Space)) << "a command's, over every view";
    const double rock_deg = model_->motion.numbers().rock_deg;
    QTest::keyClick(view->focusProxy(), Qt::Key_D);
    EXPECT_EQ(model_->motion.numbers().rock_deg, rock_deg) << "the slice uses D itself";
  }
}

TEST_F(TrainCommands, AHeldKeyFreezesOnce) {
  openCase();
  settle();
  workspace_->commands().key(QKeyEvent(QEvent::KeyPress, Qt::Key_F, Qt::NoModifier), true);
  workspace_->commands().key(QKeyEvent(QEvent::KeyPress, Qt::Key_F, Qt::NoModifier, {}, true), true);
  EXPECT_TRUE(model_->live.isFrozen());
}

}  // namespace
}  // namespace insonate::train
