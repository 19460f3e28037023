#include "SharedModel.h"

#include <insonate/cases/CaseTitle.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/ErrorPanel.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <support/TestData.h>
#include <ui/support/Patience.h>
#include <unistd.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>
#include <filesystem>
#include <fstream>
#include <optional>

namespace insonate::prepare {
namespace {

namespace fs = std::filesystem;
using test::kPatience_ms;
constexpr views::Color kChosen{12, 34, 56};

class Saving : public testing::Test {
 protected:
  void SetUp() override {
    case_ = home_ / "block";
    ASSERT_TRUE(writeCase(test::smallCase(), case_));
    workspace_ = new PrepareWorkspace(window_.tasks());
    window_.addWorkspace("prepare", "Prepare", "prepare", workspace_);
    workspace_->setCaseActions(windowAction("open"), windowAction("import"), windowAction("reload"));
    window_.show();
    window_.showWorkspace("prepare");
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
    QApplication::setActiveWindow(&window_);  // without a window manager, activation may come later or never
    shared_.emplace(modelOf(*workspace_));
    window_.open(QString::fromStdString(case_.string()));
    ASSERT_TRUE(until([this] { return window_.isReady(); }));
  }
  void TearDown() override { EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(5000))); }

  static bool until(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience_ms); }
  bool edited() const { return workspace_->unsavedEdit() != nullptr; }
  views::Color colorOnDisk() {
    const auto read = readCase(case_);
    EXPECT_TRUE(read) << (read ? "" : read.error().message);
    return read ? viewColor(caseLabelColor(read->patient.colors, kVein)) : views::Color{};
  }
  QDialog* question() { return window_.findChild<QDialog*>(); }
  void answer(const char* button) {
    ASSERT_TRUE(question());
    QTest::mouseClick(question()->findChild<QPushButton*>(button), Qt::LeftButton);
  }
  QAction* windowAction(const char* act) { return window_.commands().action(QString("window.case.") + act); }
  QAction* saveAction() { return workspace_->findChild<QAction*>("saveCase"); }

  test::TemporaryFolder home_;
  fs::path case_;
  ui::MainWindow window_;
  PrepareWorkspace* workspace_ = nullptr;
  std::optional<PrepareModel> shared_;
};

TEST_F(Saving, WritesColorsAndTitleToTheCasesFolder) {
  EXPECT_FALSE(saveAction()->isEnabled());
  shared_->appearance.setColor(kVein, kChosen);
  shared_->openCase.setTitle("Renamed");
  EXPECT_TRUE(window_.caseTitle().contains("changed"));
  shared_->crosshair.moveTo({4, 9, 2});
  ASSERT_TRUE(saveAction()->isEnabled());
  QTest::keyClick(workspace_, Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(until([this] { return !edited(); }));
  EXPECT_EQ(colorOnDisk(), kChosen);
  EXPECT_EQ(readCase(case_)->patient.manifest.title, "Renamed");
  EXPECT_EQ(window_.caseTitle(), "Renamed");
  EXPECT_EQ(window_.current().patient->colors.size(), 1U) << "other workspaces have them, too";
  EXPECT_EQ(shared_->crosshair.position_mm(), (Vec3{4, 9, 2})) << "saving moves nothing";
  EXPECT_TRUE(shared_->openCase.undoStack().canUndo());
  shared_->openCase.undoStack().undo(), shared_->openCase.undoStack().undo();
  EXPECT_TRUE(edited()) << "taken back after saving is a change again";
}

TEST_F(Saving, ACaseThatNobodyNamedIsCalledAsItsFolder) {
  PatientCase imported = test::smallCase();
  imported.manifest.title = kImportedTitle;
  const fs::path folder = home_ / "short neck.case";
  ASSERT_TRUE(writeCase(imported, folder));
  window_.open(QString::fromStdString(folder.string()));
  ASSERT_TRUE(until([this] { return window_.caseTitle() == "Imported CT"; }));
  shared_->appearance.setColor(kVein, kChosen);
  window_.saveCase();
  ASSERT_TRUE(until([this] { return window_.caseTitle() == "short neck"; }));
  EXPECT_EQ(shared_->openCase.title(), "short neck");
  EXPECT_FALSE(edited());
}

TEST_F(Saving, WhatSomebodyElseSavedMeanwhileIsKeptAndSaid) {
  PatientCase theirs = test::smallCase();
  theirs.labels.voxels[0] = kVein;
  ASSERT_TRUE(saveCaseVersion(theirs, case_, "2026-11-22", ""));
  const auto save = [&](views::Color color) {
    shared_->appearance.setColor(kVein, color);
    window_.saveCase();
    EXPECT_TRUE(until([this] { return !edited(); }));
    return window_.statusText();
  };
  EXPECT_TRUE(save(kChosen).contains("Another user had saved the case in the meantime"));
  const auto kept = findVersion(case_, voxelHashOf(theirs));
  ASSERT_TRUE(kept);
  EXPECT_EQ(readCase(*kept)->patient.labels.voxels[0], kVein);
  EXPECT_FALSE(save({65, 43, 21}).contains("Somebody")) << "said once";
  ASSERT_TRUE(publishCase(readCase(case_)->patient, case_, "2026-11-22"));
  EXPECT_FALSE(save({1, 2, 3}).contains("Somebody")) << "publishing writes the same again";
}

TEST_F(Saving, ClosesAtOnceWithoutChangesAndAsksWithThem) {
  shared_->appearance.setVisible(kVein, false);
  shared_->appearance.setColor(kVein, kChosen);
  EXPECT_FALSE(window_.close());
  EXPECT_TRUE(window_.isVisible());
  answer("keep");
  QTest::qWait(50);
  EXPECT_TRUE(window_.isVisible());
  EXPECT_TRUE(edited());

  window_.close();
  answer("save");
  ASSERT_TRUE(until([this] { return !window_.isVisible(); }));
  EXPECT_EQ(colorOnDisk(), kChosen);
}

TEST_F(Saving, NothingAskedWithoutChanges) {
  shared_->appearance.setVisible(kVein, false);
  EXPECT_TRUE(window_.close());
  EXPECT_FALSE(question());
}

TEST_F(Saving, WhatIsHiddenOrTranslucentIsWrittenToo) {
  shared_->appearance.setVisible(kBone, false);
  shared_->appearance.setOpacity(kVein, 0.35);
  ASSERT_TRUE(saveAction()->isEnabled());
  QTest::keyClick(workspace_, Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(until([this] { return !workspace_->unpromptedEdit(); }));
  EXPECT_FALSE(saveAction()->isEnabled());
  const auto shown = readCase(case_)->patient.manifest.shown;
  EXPECT_FALSE(shown.at(kBone).visible);
  EXPECT_NEAR(shown.at(kVein).opacity, 0.35, 1e-9);
  EXPECT_TRUE(shown.at(kVein).visible);
  shared_->appearance.setVisible(kBone, true);
  shared_->openCase.setCase(std::make_shared<const PatientCase>(readCase(case_)->patient));
  EXPECT_FALSE(shared_->appearance.look(kBone).visible) << "a case looks as it was saved, whatever was looked at since";
  EXPECT_FALSE(workspace_->unpromptedEdit());
}

TEST_F(Saving, ACaseThatIsNowhereIsAskedAboutOnce) {
  Q_EMIT workspace_->caseMade(std::make_shared<const PatientCase>(test::smallCase()));
  ASSERT_TRUE(until([this] { return window_.isReady(); }));
  EXPECT_TRUE(saveAction()->isEnabled());
  shared_->appearance.setColor(kVein, kChosen);
  EXPECT_FALSE(window_.close());
  EXPECT_EQ(window_.findChildren<QDialog*>().size(), 1);
  answer("goOn");
  EXPECT_TRUE(until([this] { return !window_.isVisible(); }));
}

TEST_F(Saving, WhereTheProbeIsBecomesTheStartOfACaseThatHasNone) {
  auto* keep = workspace_->findChild<QPushButton*>("keepStart");
  ASSERT_TRUE(keep);
  EXPECT_FALSE(keep->isVisible()) << "this case has one";
  PatientCase without = test::smallCase();
  without.manifest.startPoses.clear();
  ASSERT_TRUE(writeCase(without, case_));
  QTest::keyClick(&window_, Qt::Key_F5);
  ASSERT_TRUE(until([&] { return window_.isReady() && keep->isVisible(); }));
  QApplication::processEvents();
  for (const auto* label : keep->parentWidget()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
    EXPECT_TRUE(label->wordWrap() || label->width() >= label->sizeHint().width()) << label->text().toStdString();
  shared_->crosshair.moveTo({8, 3, 2});
  ASSERT_TRUE(until([this] { return window_.isReady(); }));
  ASSERT_TRUE(shared_->live.pose());
  const Transform stood = *shared_->live.pose();
  EXPECT_EQ(keep->text(), "Set start pose");
  keep->click();
  EXPECT_TRUE(workspace_->statusText().startsWith("The probe's pose is now the start pose"))
      << workspace_->statusText().toStdString();
  EXPECT_FALSE(keep->isVisible());
  EXPECT_TRUE(edited());
  shared_->openCase.undoStack().undo();
  EXPECT_TRUE(keep->isVisible());
  EXPECT_FALSE(edited());
  EXPECT_TRUE(shared_->live.start()) << "found by itself, as before";
  shared_->openCase.undoStack().redo();
  saveAction()->trigger();
  ASSERT_TRUE(until([this] { return !edited() && !window_.tasks().isRunning(); }));
  const auto read = readCase(case_);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->patient.manifest.startPoses.size(), 1u);
  const StartPose& start = read->patient.manifest.startPoses[0];
  EXPECT_NEAR(start.position_mm.x, 8, 1);
  const auto begins = patientFromProbe(start.position_mm, start.axial, start.lateral);
  ASSERT_TRUE(begins);
  EXPECT_LT(norm(begins->offset - stood.offset), 1e-3) << "where the probe stood";
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_LT(norm(begins->linear.column[axis] - stood.linear.column[axis]), 1e-4) << "and as it was held";
  EXPECT_FALSE(keep->isVisible());
  QTest::keyClick(&window_, Qt::Key_F5);
  ASSERT_TRUE(until([this] { return window_.isReady() && shared_->live.start(); }));
  EXPECT_EQ(shared_->live.start()->position_mm, start.position_mm) << "the case opens there";
}

TEST_F(Saving, EditedLabelsAreAskedAboutWrittenAndReadBack) {
  LabelSession& labels = shared_->labeling;
  LabelStep step;
  step.tool = step::Paint{.radius_mm = 3};
  step.label = kArtery;
  ASSERT_TRUE(labels.beginStroke(step, "paint"));
  labels.strokeTo({-10, 10, 0});
  labels.endStroke();
  EXPECT_TRUE(edited());
  EXPECT_TRUE(window_.caseTitle().contains("changed"));
  EXPECT_FALSE(window_.close());
  answer("keep");
  saveAction()->trigger();
  ASSERT_TRUE(until([this] { return !edited() && !window_.tasks().isRunning(); }));
  const auto read = readCase(case_);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->patient.labels.voxels, labels.labels().voxels);
  EXPECT_GT(std::ranges::count(read->patient.labels.voxels, kArtery), 0);
  EXPECT_EQ(window_.current().patient->labels.voxels, labels.labels().voxels) << "Train has them, too";
  shared_->openCase.undoStack().undo();
  EXPECT_TRUE(edited()) << "taken back after saving is a change again";
  shared_->openCase.undoStack().redo();
  EXPECT_FALSE(edited());
}

TEST_F(Saving, WhatIsPaintedWhileItIsWrittenIsAChangeAfterwards) {
  LabelSession& labels = shared_->labeling;
  LabelStep step;
  step.tool = step::Paint{.radius_mm = 3};
  step.label = kArtery;
  const auto paint = [&](Vec3 at_mm) {
    ASSERT_TRUE(labels.beginStroke(step, "paint"));
    labels.strokeTo(at_mm);
    labels.endStroke();
  };
  paint({-10, 10, 0});
  const auto first = labels.labels().voxels;
  saveAction()->trigger();
  paint({10, 10, 0});
  ASSERT_TRUE(until([this] { return !window_.tasks().isRunning(); }));
  EXPECT_EQ(readCase(case_)->patient.labels.voxels, first);
  EXPECT_TRUE(edited());
}

TEST_F(Saving, DiscardLeavesTheFolderAlone) {
  shared_->appearance.setColor(kVein, kChosen);
  window_.close();
  answer("goOn");
  ASSERT_TRUE(until([this] { return !window_.isVisible(); }));
  EXPECT_NE(colorOnDisk(), kChosen);
}

TEST_F(Saving, ReloadRereadsTheFolder) {
  PatientCase relabeled = test::smallCase();
  std::ranges::replace(relabeled.labels.voxels, std::uint8_t{kVein}, std::uint8_t{kArtery});
  ASSERT_TRUE(writeCase(relabeled, case_));
  QTest::keyClick(&window_, Qt::Key_F5);
  ASSERT_TRUE(until([this] {
    return shared_->openCase.patient()->labels.voxels[0] == 0 && window_.isReady() &&
           shared_->structures.labels().size() == 4 && shared_->structures.labels()[1] == kArtery;
  }));

  shared_->appearance.setColor(kArtery, kChosen);
  windowAction("reload")->trigger();
  answer("goOn");
  ASSERT_TRUE(until([this] { return window_.isReady() && !edited(); }));
  EXPECT_NE(shared_->appearance.look(kArtery).color, kChosen);
}

TEST_F(Saving, AFolderThatCannotBeWrittenGivesASentenceAndKeepsTheChanges) {
  shared_->appearance.setColor(kVein, kChosen);
  fs::remove_all(case_);
  std::ofstream(case_) << "in the way";
  saveAction()->trigger();
  ASSERT_TRUE(until([this] { return window_.errors().isVisible(); }));
  EXPECT_TRUE(window_.errors().message().endsWith('.')) << window_.errors().message().toStdString();
  EXPECT_TRUE(edited());
  EXPECT_TRUE(saveAction()->isEnabled());
}

TEST_F(Saving, AReadOnlyFolderGivesASentence) {
  if (geteuid() == 0) GTEST_SKIP() << "the superuser may write everywhere";
  fs::permissions(home_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  shared_->appearance.setColor(kVein, kChosen);
  saveAction()->trigger();
  EXPECT_TRUE(until([this] { return window_.errors().isVisible(); }));
  EXPECT_TRUE(edited());
  fs::permissions(home_.path(), fs::perms::owner_all);
}

TEST_F(Saving, ClosingWhileItComputesNeitherHangsNorBreaksTheCase) {
  for (const int wait_ms : {0, 5, 30, 100, 400}) {
    ui::MainWindow window;
    auto* workspace = new PrepareWorkspace(window.tasks());
    window.addWorkspace("prepare", "Prepare", "prepare", workspace);
    window.show();
    window.open(QString::fromStdString(case_.string()));
    QTest::qWait(wait_ms);
    window.close();
    EXPECT_FALSE(window.isVisible());
  }
  EXPECT_TRUE(readCase(case_));
}

}  // namespace
}  // namespace insonate::prepare
