#include "ToolsWindow.h"
#include "tools/RangeStrip.h"
#include "tools/Tool.h"

#include <QMenu>
#include <QSpinBox>
#include <QTimer>

namespace insonate::prepare {
namespace {

/// Rules for tools, the range on the histogram, and labels chosen by name.
class ToolRules : public Tools {
 protected:
  void choose(const char* box, const QString& word) {
    auto* combo = child<QComboBox>(box);
    const int row = combo->findText(word);
    ASSERT_GE(row, 0) << word.toStdString();
    combo->setCurrentIndex(row);
    Q_EMIT combo->activated(row);
  }
  /// Labels under a stroke of the brush, before and after it.
  void paintOverEverything() {
    shared_->structures.add(kArtery);
    key(Qt::Key_1);
    child<ui::ValueSlider>("tool-radius")->setValue(9);
    drag({-4, 12, 0}, {4, 30, 0});
  }
  std::size_t was(std::uint8_t label) const { return std::size_t(std::ranges::count(patient()->labels.voxels, label)); }
  bool previewed() {
    return QTest::qWaitFor([&] { return shared_->labeling.preview().proposal() != nullptr; }, kPatience_ms);
  }
};

TEST_F(ToolRules, ABrushOverEverythingTakesFromEveryLabelButLockedAndHiddenOnes) {
  shared_->labeling.setLocked(kBone, true);
  shared_->appearance.setVisible(kVein, false);
  paintOverEverything();
  EXPECT_EQ(count(kBone), was(kBone)) << "locked";
  EXPECT_EQ(count(kVein), was(kVein)) << "hidden";
  EXPECT_LT(count(kSoftTissue), was(kSoftTissue));
  EXPECT_GT(count(kArtery), 0u);
  child<QAction>("undo")->trigger();
  shared_->labeling.setLocked(kBone, false);
  shared_->appearance.setVisible(kVein, true);
  key(Qt::Key_1);
  drag({-4, 12, 0}, {4, 30, 0});
  EXPECT_LT(count(kBone), was(kBone));
  EXPECT_LT(count(kVein), was(kVein));
}

TEST_F(ToolRules, ToolsThatGrowSeveralLabelsIgnoreThatTheSelectedOneIsLocked) {
  shared_->labeling.setLocked(kVein, true);
  for (const char* tool : {"tool-seeds", "tool-watershed"}) {
    child<QAction>(tool)->trigger();
    key(Qt::Key_Return);
    ASSERT_TRUE(done());
    EXPECT_LT(count(kSoftTissue), was(kSoftTissue)) << tool << ": " << workspace_->statusText().toStdString();
    EXPECT_EQ(count(kVein), was(kVein)) << "locked";
    child<QAction>("undo")->trigger();
  }
}

TEST_F(ToolRules, WhatMayBeOverwrittenIsChosenInThePanel) {
  key(Qt::Key_1);
  choose("ruleOver", "fat, muscle, soft tissue");
  paintOverEverything();
  EXPECT_EQ(count(kVein), was(kVein));
  EXPECT_EQ(count(kBone), was(kBone));
  EXPECT_LT(count(kSoftTissue), was(kSoftTissue));
}

TEST_F(ToolRules, InsideOneLabelNothingElseIsOverwritten) {
  key(Qt::Key_1);
  EXPECT_FALSE(child<QComboBox>("ruleInside")->isVisible());
  choose("ruleOver", "only the label below");
  EXPECT_TRUE(child<QComboBox>("ruleInside")->isVisible());
  choose("ruleInside", structureName(kBone));
  paintOverEverything();
  EXPECT_EQ(count(kVein), was(kVein));
  EXPECT_EQ(count(kSoftTissue), was(kSoftTissue));
  EXPECT_EQ(count(kBone) + count(kArtery), was(kBone));
  EXPECT_GT(count(kArtery), 0u);
}

TEST_F(ToolRules, OutsideTheEditableRangeNoToolWrites) {
  key(Qt::Key_1);
  child<QCheckBox>("ruleLimited")->click();
  child<QSpinBox>("editable-from")->setValue(700);
  child<QSpinBox>("editable-to")->setValue(1000);
  paintOverEverything();
  ASSERT_GT(count(kArtery), 0u);
  for (std::size_t n = 0; n < labels().voxels.size(); ++n) {
    if (labels().voxels[n] != kArtery) continue;
    ASSERT_EQ(patient()->ct.voxels[n], 900);
  }
  child<QCheckBox>("ruleLimited")->click();
  EXPECT_FALSE(shared_->labeling.rules().editable);
}

TEST_F(ToolRules, EitherEndOfTheRangeIsDraggedOnTheHistogram) {
  shared_->structures.add(kCartilage);
  key(Qt::Key_5);
  ASSERT_TRUE(previewed()) << "the range is shown at once";
  auto* strip = child<RangeStrip>("tool-strip");
  ASSERT_TRUE(QTest::qWaitFor([&] { return strip->huAt(strip->width()) < 3000; }, kPatience_ms)) << "counted";
  const auto dragTo = [&](double from_HU, double to_HU) {
    QTest::mousePress(strip, Qt::LeftButton, {}, QPoint(int(strip->placeOf(from_HU)), 30));
    QMouseEvent move(QEvent::MouseMove, QPointF(strip->placeOf(to_HU), 30), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(strip, &move);
    QTest::mouseRelease(strip, Qt::LeftButton, {}, QPoint(int(strip->placeOf(to_HU)), 30));
  };
  const double px_HU = strip->huAt(11) - strip->huAt(10);
  dragTo(150, 400);
  EXPECT_NEAR(child<QSpinBox>("tool-from")->value(), 400, px_HU);
  EXPECT_EQ(child<QSpinBox>("tool-to")->value(), 600);
  dragTo(500, 600);
  EXPECT_NEAR(child<QSpinBox>("tool-from")->value(), 500, 2 * px_HU) << "the band moves both";
  EXPECT_NEAR(child<QSpinBox>("tool-to")->value(), 700, 2 * px_HU);
  dragTo(child<QSpinBox>("tool-to")->value(), 0);
  EXPECT_EQ(child<QSpinBox>("tool-from")->value(), child<QSpinBox>("tool-to")->value()) << "they do not pass";
}

TEST_F(ToolRules, OtsuPartsTheHistogramInTheRange) {
  key(Qt::Key_5);
  auto* strip = child<RangeStrip>("tool-strip");
  ASSERT_TRUE(QTest::qWaitFor([&] { return strip->huAt(strip->width()) < 3000; }, kPatience_ms));
  child<QPushButton>("tool-all")->click();
  child<QPushButton>("tool-brighter")->click();
  const int tissue = child<QSpinBox>("tool-from")->value();
  EXPECT_GT(tissue, -1000) << "air on one side";
  EXPECT_LT(tissue, 40) << "tissue on the other";
  child<QPushButton>("tool-brighter")->click();
  EXPECT_GT(child<QSpinBox>("tool-from")->value(), 40);
  EXPECT_LT(child<QSpinBox>("tool-from")->value(), 900);
  EXPECT_TRUE(previewed());
}

TEST_F(ToolRules, TheLabelOfTheToolIsChosenInItsPanel) {
  key(Qt::Key_1);
  choose("toolFor", structureName(kBone));
  EXPECT_EQ(shared_->structures.selected(), kBone);
  shared_->structures.select(kVein);
  EXPECT_EQ(child<QComboBox>("toolFor")->currentText(), structureName(kVein));
}

TEST_F(ToolRules, CombiningTakesTheOtherLabelByName) {
  child<QAction>("tool-logical")->trigger();
  EXPECT_FALSE(child<QPushButton>("toolApply")->isEnabled()) << "no other label is chosen yet";
  choose("toolOther", structureName(kBone));
  ASSERT_TRUE(child<QPushButton>("toolApply")->isEnabled());
  child<QPushButton>("toolApply")->click();
  ASSERT_TRUE(done());
  EXPECT_EQ(count(kVein), was(kVein) + was(kBone));
}

/// A radius below a voxel would change nothing, and look broken.
TEST_F(ToolRules, SmoothingBeginsAtAVoxelAndSaysHowMuchItChanged) {
  auto coarse = std::make_shared<PatientCase>(*patient());
  coarse->ct.geometry.spacing_mm = coarse->labels.geometry.spacing_mm = {3.21, 3.21, 5};
  coarse->labels.at(5, 20, 8) = kVein;  // a speck
  openCase(coarse);
  shared_->structures.select(kVein);
  child<QAction>("tool-median")->trigger();
  auto* radius = child<ui::ValueSlider>("tool-radius");
  EXPECT_DOUBLE_EQ(radius->range().minimum, 3.3);
  EXPECT_DOUBLE_EQ(radius->value(), 3.3);
  child<QPushButton>("toolApply")->click();
  ASSERT_TRUE(done());
  std::size_t changed = 0;
  for (std::size_t v = 0; v < labels().voxels.size(); ++v) changed += labels().voxels[v] != coarse->labels.voxels[v];
  ASSERT_GT(changed, 0u);
  const QString volume = QString::number(double(changed) * 3.21 * 3.21 * 5 / 1000, 'f', 2);
  EXPECT_EQ(shared_->statusLine.text(), "Median vein: " + volume + " ml changed; Ctrl+Z undoes it.");
}

TEST_F(ToolRules, WhatIsStoppedChangesNothingAndSaysSo) {
  const auto before = labels().voxels;
  const int steps = shared_->openCase.undoStack().count();
  child<QAction>("tool-levelset")->trigger();
  child<ui::ValueSlider>("tool-rounds")->setValue(1000);
  child<QPushButton>("toolApply")->click();
  child<QPushButton>("toolLeave")->click();
  ASSERT_TRUE(done());
  EXPECT_EQ(labels().voxels, before);
  EXPECT_EQ(shared_->openCase.undoStack().count(), steps);
  EXPECT_EQ(shared_->statusLine.text(), "Level set vein: stopped; no label was changed.");
}

TEST_F(ToolRules, WhatLiesNearAnotherLabelIsTakenAway) {
  child<QAction>("tool-logical")->trigger();
  choose("toolOther", structureName(kSoftTissue));
  choose("tool-do", "subtract");
  child<QPushButton>("toolApply")->click();
  ASSERT_TRUE(done());
  EXPECT_TRUE(child<QLabel>("toolTold")->text().contains("reach")) << "it says what is missing";
  EXPECT_EQ(count(kVein), was(kVein));
  child<ui::ValueSlider>("tool-reach")->setValue(1);
  child<QPushButton>("toolApply")->click();
  ASSERT_TRUE(done());
  EXPECT_GT(count(kVein), 0u);
  EXPECT_LT(count(kVein), was(kVein)) << "its rim, which touches soft tissue";
}

TEST_F(ToolRules, TheBrushIsSizedByKeysAndWheelWithinWhatTheVoxelsAllow) {
  key(Qt::Key_1);
  auto* radius = child<ui::ValueSlider>("tool-radius");
  EXPECT_DOUBLE_EQ(radius->range().minimum, 0.5) << "half a voxel of 1 mm";
  const double before = radius->value();
  key(Qt::Key_BracketRight);
  EXPECT_GT(radius->value(), before);
  key(Qt::Key_BracketLeft);
  EXPECT_NEAR(radius->value(), before, 0.06);
  QWheelEvent wheel(QPointF(50, 50), QPointF(50, 50), {}, {0, -120}, Qt::NoButton, Qt::ShiftModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(canvas("Axial slice"), &wheel);
  EXPECT_LT(radius->value(), before);
  for (int n = 0; n < 60; ++n) key(Qt::Key_Minus);
  EXPECT_DOUBLE_EQ(radius->value(), radius->range().minimum);
  for (int n = 0; n < 60; ++n) key(Qt::Key_Plus);
  EXPECT_DOUBLE_EQ(radius->value(), radius->range().maximum);
}

TEST_F(ToolRules, KeysOfToolsWorkFromTheTable) {
  table()->setFocus();
  QTest::keyClick(table(), Qt::Key_5);
  EXPECT_TRUE(child<QToolButton>("tool-threshold")->isChecked());
}

TEST_F(ToolRules, ThePaletteIsWrittenInTheWindowsOwnSize) {
  EXPECT_GE(child<QToolButton>("tool-paint")->font().pointSizeF(), workspace_->font().pointSizeF());
}

TEST_F(ToolRules, EnterInARangeEndsTheNumberAndTheWindowHasItsKeysAgain) {
  shared_->structures.add(kArtery);
  key(Qt::Key_5);
  auto* from = child<QSpinBox>("tool-from");
  from->setFocus();
  from->selectAll();
  QTest::keyClicks(from, "800");
  QTest::keyClick(from, Qt::Key_Return);
  EXPECT_EQ(from->value(), 800) << "what is typed stays";
  EXPECT_EQ(child<QSpinBox>("tool-to")->value(), 800) << "and the other end gives way";
  EXPECT_FALSE(shared_->labeling.isBusy());
  EXPECT_EQ(count(kArtery), 0u) << "nothing is written yet";
  EXPECT_FALSE(from->hasFocus());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_1);
  EXPECT_TRUE(child<QToolButton>("tool-paint")->isChecked());
}

TEST_F(ToolRules, ThePaletteShowsWhichToolIsInHand) {
  const auto ground = [this](const char* tool) { return child<QToolButton>(tool)->grab().toImage().pixelColor(4, 4); };
  const QColor idle = ground("tool-paint");
  key(Qt::Key_1);
  EXPECT_NE(ground("tool-paint"), idle);
  EXPECT_EQ(ground("tool-grow"), idle);
  key(Qt::Key_6);
  EXPECT_EQ(ground("tool-paint"), idle);
  EXPECT_NE(ground("tool-grow"), idle) << "one of a group";
}

TEST_F(ToolRules, AGroupWhoseMenuIsClosedLooksAsIfNobodyPointedAtIt) {
  auto* grow = child<QToolButton>("tool-grow");
  const QColor idle = grow->grab().toImage().pixelColor(4, 4);
  grow->setAttribute(Qt::WA_UnderMouse);
  EXPECT_NE(grow->grab().toImage().pixelColor(4, 4), idle);
  QTimer::singleShot(0, grow->menu(), &QMenu::close);
  grow->showMenu();
  EXPECT_EQ(grow->grab().toImage().pixelColor(4, 4), idle);
}

}  // namespace
}  // namespace insonate::prepare
