#include "ToolsWindow.h"
#include "tools/Tool.h"

#include <gmock/gmock.h>

#include <QMenu>
#include <QTabBar>
#include <QTreeWidget>

namespace insonate::prepare {
namespace {

TEST_F(Tools, APaintedStrokeIsExactlyTheCircleAlongItInItsSlice) {
  shared_->structures.add(kArtery);
  key(Qt::Key_1);
  const Vec3 a = placeOf({-14, 12, 0}), b = placeOf({-8, 14, 0});
  LabelMap expected = patient()->labels;
  const int slice = 8;  // z = 0
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 49; ++i) {
      const Vec3 at{i - 24.0, j - 6.0, 0};
      const double along = std::clamp(dot(at - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
      if (norm(at - (a + (b - a) * along)) <= 4) expected.at(i, j, slice) = kArtery;
    }
  drag({-14, 12, 0}, {-8, 14, 0});
  EXPECT_EQ(labels().voxels, expected.voxels);
  shared_->openCase.undoStack().undo();
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
  auto* shape = child<QComboBox>("tool-shape");
  shape->setCurrentIndex(shape->findText("sphere"));
  Q_EMIT shape->activated(shape->currentIndex());
  drag({-14, 12, 0}, {-8, 14, 0});
  EXPECT_EQ(labels().at(24 - 11, 6 + 13, slice + 2), kArtery) << "a sphere reaches into other slices";
}

TEST_F(Tools, WhatPaintsAtOnceIsDoneAndNotCancelled) {
  auto* leave = child<QPushButton>("toolLeave");
  key(Qt::Key_1);
  EXPECT_EQ(leave->text(), "Done");
  key(Qt::Key_6);
  EXPECT_EQ(leave->text(), "Cancel");
}

TEST_F(Tools, ErasingTakesOnlyTheCurrentLabelAndLeavesTissue) {
  key(Qt::Key_2);
  drag({0, 2, 0}, {0, 20, 0});
  EXPECT_EQ(labels().at(24, 18, 8), kSoftTissue);
  EXPECT_EQ(count(kSkin), std::size_t(std::ranges::count(patient()->labels.voxels, kSkin)));
  EXPECT_LT(count(kVein), std::size_t(std::ranges::count(patient()->labels.voxels, kVein)));
}

TEST_F(Tools, ConnectedGrowingFromAClickIsShownAppliedAndTakenBack) {
  key(Qt::Key_6);
  auto* apply = child<QPushButton>("toolApply");
  EXPECT_FALSE(apply->isEnabled()) << "nothing is clicked yet";
  EXPECT_EQ(child<QPushButton>("toolLeave")->text(), "Cancel");
  shared_->structures.add(kCartilage);
  click({0, 30, 0});
  click({10, 10, 0});
  click({10, 10, 0}, Qt::RightButton);
  ASSERT_TRUE(apply->isEnabled());
  EXPECT_TRUE(child<QLabel>("toolAdvice")->text().endsWith("Clicks so far: 1."));
  child<QSpinBox>("tool-to")->setValue(1000);
  child<QPushButton>("toolPreview")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return shared_->labeling.preview().proposal() != nullptr; }, kPatience_ms));
  EXPECT_EQ(labels().voxels, patient()->labels.voxels) << "only shown";
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  EXPECT_EQ(count(kCartilage), std::size_t(std::ranges::count(patient()->ct.voxels, 900)));
  EXPECT_FALSE(shared_->labeling.preview().proposal());
  child<QAction>("undo")->trigger();
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
}

TEST_F(Tools, EnterInTheTableAppliesTheToolWhoseLabelWasChosenThere) {
  auto* table = child<QTableView>("structures");
  table->setFocus();
  QTest::keyClick(table, Qt::Key_0);  // Margin
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_FALSE(QApplication::activeModalWidget()) << "no colour is asked for";
  ASSERT_TRUE(done());
  EXPECT_GT(count(kVein), std::size_t(std::ranges::count(patient()->labels.voxels, kVein)));
}

TEST_F(Tools, AClickShowsAtOnceWhatComesOfIt) {
  const auto shown = [&] { return shared_->labeling.preview().proposal() != nullptr; };
  shared_->structures.add(kCartilage);
  child<QAction>("tool-march")->trigger();
  click({0, 30, 0});
  EXPECT_TRUE(QTest::qWaitFor(shown, kPatience_ms));
  EXPECT_EQ(labels().voxels, patient()->labels.voxels) << "only shown";
  click({0, 30, 0}, Qt::RightButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !shown(); }, kPatience_ms)) << "its last click is taken back";
}

TEST_F(Tools, APreviewThatTakesAWhileSaysSoAndEscapeEndsIt) {
  shared_->structures.select(kSoftTissue);
  child<QAction>("tool-levelset")->trigger();
  child<ui::ValueSlider>("tool-rounds")->setValue(1000);
  auto* preview = child<QPushButton>("toolPreview");
  preview->click();
  ASSERT_TRUE(shared_->labeling.preview().isComputing());
  EXPECT_TRUE(QTest::qWaitFor([&] { return preview->text() == "Computing ..."; }, kPatience_ms));
  key(Qt::Key_Escape);
  EXPECT_FALSE(shared_->labeling.preview().isComputing());
  EXPECT_EQ(preview->text(), "Preview");
  EXPECT_TRUE(child<QToolButton>("tool-grow")->isChecked()) << "the tool stays in hand";
  key(Qt::Key_7);
  EXPECT_FALSE(shared_->labeling.preview().isComputing()) << "another tool shows nothing that nobody asked for";
}

TEST_F(Tools, WhyNothingCameOfAToolIsReadWholeInItsPanel) {
  key(Qt::Key_6);
  click({20, 12, 0});
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  auto* told = child<QLabel>("toolTold");
  ASSERT_TRUE(QTest::qWaitFor([&] { return told->isVisible(); }, kPatience_ms));
  EXPECT_THAT(told->text().toStdString(), testing::HasSubstr("from 150 to 600 HU"));
  EXPECT_GE(told->height(), told->heightForWidth(told->width()));
  child<QSpinBox>("tool-from")->setValue(0);
  EXPECT_FALSE(told->isVisible()) << "another range is another try";
}

TEST_F(Tools, WithoutALabelThePanelSaysWhereToGetOne) {
  shared_->structures.select(kBackground);
  key(Qt::Key_5);
  EXPECT_FALSE(child<QPushButton>("toolApply")->isEnabled());
  EXPECT_THAT(child<QLabel>("toolAdvice")->text().toStdString(), testing::HasSubstr("or add one"));
  shared_->structures.select(kVein);
  EXPECT_THAT(child<QLabel>("toolAdvice")->text().toStdString(), testing::HasSubstr("in the range"));
}

TEST_F(Tools, ThresholdFollowsItsSlidersAndAClick) {
  key(Qt::Key_5);
  click({0, 30, 0});
  EXPECT_EQ(child<QSpinBox>("tool-from")->value(), 840);
  shared_->structures.add(kCartilage);
  ASSERT_TRUE(QTest::qWaitFor([&] { return shared_->labeling.preview().proposal() != nullptr; }, kPatience_ms));
  child<QPushButton>("toolApply")->click();
  ASSERT_TRUE(done());
  EXPECT_EQ(count(kBone), 0u);
  EXPECT_GT(count(kCartilage), 0u);
}

TEST_F(Tools, ADrawnOutlineIsFilledByEnter) {
  shared_->structures.add(kArtery);
  key(Qt::Key_3);
  for (const Vec3 corner : {Vec3{-14.5, 9.5, 0}, Vec3{-8.5, 9.5, 0}, Vec3{-8.5, 15.5, 0}, Vec3{-14.5, 15.5, 0}})
    click(corner);
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  EXPECT_EQ(labels().at(24 - 11, 6 + 13, 8), kArtery);
  EXPECT_EQ(labels().at(24 - 11, 6 + 13, 9), kSoftTissue) << "in this slice only";
  EXPECT_EQ(count(kArtery), 36u);
}

TEST_F(Tools, EscapeForgetsClicksThenLaysTheToolAway) {
  const Vec3 before = shared_->crosshair.position_mm();
  key(Qt::Key_6);
  click({10, 10, 0});
  EXPECT_EQ(shared_->crosshair.position_mm(), before) << "the tool has the mouse";
  EXPECT_TRUE(child<QPushButton>("toolApply")->isEnabled());
  key(Qt::Key_Escape);
  EXPECT_FALSE(child<QPushButton>("toolApply")->isEnabled());
  EXPECT_TRUE(child<QToolButton>("tool-grow")->isChecked());
  key(Qt::Key_Escape);
  EXPECT_TRUE(child<QToolButton>("tool-none")->isChecked());
  click({10, 10, 0});
  EXPECT_NE(shared_->crosshair.position_mm(), before);
}

TEST_F(Tools, EveryToolIsInThePaletteAndItsPanelSaysWhatToDo) {
  for (const Tool& tool : toolTable()) {
    if (tool.group.isEmpty())
      child<QToolButton>(("tool-" + tool.id).toUtf8())->click();
    else
      child<QAction>(("tool-" + tool.id).toUtf8())->trigger();
    QApplication::processEvents();
    EXPECT_TRUE(child<QLabel>("toolLabel")->text().contains(tool.name)) << tool.id.toStdString();
    EXPECT_FALSE(tool.advice.isEmpty());
    for (const ToolNumber& number : tool.numbers) {
      EXPECT_LE(number.range.minimum, number.range.defaultValue) << tool.id.toStdString() << number.name.toStdString();
      EXPECT_GE(number.range.maximum, number.range.defaultValue) << tool.id.toStdString() << number.name.toStdString();
    }
  }
}

TEST_F(Tools, TheTableAddsLocksAndClearsLabels) {
  const int before = table()->model()->rowCount();
  auto* menu = child<QPushButton>("addLabel")->menu();
  Q_EMIT menu->aboutToShow();
  ASSERT_GT(menu->actions().size(), 2);
  EXPECT_TRUE(menu->actions().front()->toolTip().startsWith("SNOMED"));
  menu->actions().front()->trigger();
  EXPECT_EQ(table()->model()->rowCount(), before + 1);
  shared_->structures.select(kVein);
  key(Qt::Key_L);
  EXPECT_TRUE(shared_->labeling.rules().locked.test(kVein));
  child<QPushButton>("clearLabel")->click();
  ASSERT_TRUE(done());
  EXPECT_GT(count(kVein), 0u) << "it is locked";
  clickCell(kVein, kLock);
  EXPECT_FALSE(shared_->labeling.rules().locked.test(kVein));
  child<QPushButton>("clearLabel")->click();
  ASSERT_TRUE(done());
  EXPECT_EQ(count(kVein), 0u);
}

TEST_F(Tools, AToolInHandHasMouseAndKeysBeforeTheGuideAndSaysSo) {
  auto* tabs = child<QTabBar>("labelling");
  tabs->setCurrentIndex(0);
  auto* steps = child<QTreeWidget>("guideSteps");
  steps->setCurrentItem(steps->topLevelItem(1));
  auto* clicks = child<QLabel>("guideClicks");
  QApplication::processEvents();
  ASSERT_TRUE(clicks->text().startsWith("No clicks yet"));
  const QString step = child<QLabel>("guideTitle")->text();
  key(Qt::Key_6);
  click({0, 30, 0});
  EXPECT_TRUE(clicks->text().startsWith("No clicks yet")) << "the tool has the mouse";
  EXPECT_TRUE(child<QPushButton>("toolApply")->isEnabled());
  const auto remarks = workspace_->findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(remarks, [](const QLabel* label) {
    return label->isVisible() && label->text().contains("pauses the labeling guide");
  }));
  key(Qt::Key_Backspace);
  EXPECT_FALSE(child<QPushButton>("toolApply")->isEnabled()) << "its last click is taken back";
  shared_->structures.add(kCartilage);
  click({0, 30, 0});
  child<QSpinBox>("tool-to")->setValue(1000);
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  EXPECT_GT(count(kCartilage), 0u) << "Enter applies the tool";
  EXPECT_EQ(child<QLabel>("guideTitle")->text(), step);
  key(Qt::Key_Escape);
  click({0, 12, 0});
  EXPECT_TRUE(clicks->text().startsWith("Clicks so far: 1")) << "the guide has it again";
}

}  // namespace
}  // namespace insonate::prepare
