#include "SharedModel.h"
#include "recovery/KeptFolder.h"
#include "recovery/UnsavedKeeper.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/UnsavedWork.h>
#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/ErrorPanel.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <support/TestData.h>
#include <ui/support/Patience.h>

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest/QTest>
#include <filesystem>
#include <fstream>
#include <memory>

namespace insonate::prepare {
namespace {

namespace fs = std::filesystem;
using test::kPatience_ms;
using testing::HasSubstr;
using testing::Not;

/// A label without voxels in the case.
constexpr std::uint8_t kOther = kNerve;

constexpr const char *kChildCase = "INSONATE_TEST_CASE", *kChildRoot = "INSONATE_TEST_ROOT";

bool until(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, kPatience_ms);
}

/// A window with the workspace, as the program has it.
class Program {
 public:
  explicit Program(const fs::path& root) {
    workspace_ = new PrepareWorkspace(window_.tasks());
    window_.addWorkspace("prepare", "Prepare", "prepare", workspace_);
    window_.show();
    window_.showWorkspace("prepare");
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
    workspace_->keepUnsavedWorkIn(QString::fromStdString(root.string()));
    model_ = std::make_unique<PrepareModel>(modelOf(*workspace_));
    kept_ = std::make_unique<QSignalSpy>(keeper(), &UnsavedKeeper::kept);
  }
  void open(const fs::path& folder) {
    window_.open(QString::fromStdString(folder.string()));
    const QString path = QString::fromStdString(folder.string());
    ASSERT_TRUE(until([&] { return window_.isReady() && workspace_->isReady() && window_.current().folder == path; }));
  }
  void paint(Vec3 at_mm) {
    LabelStep step;
    step.tool = step::Paint{.radius_mm = 3};
    step.label = kArtery;
    keptBefore_ = kept_->count();
    ASSERT_TRUE(model_->labeling.beginStroke(step, "paint"));
    model_->labeling.strokeTo(at_mm);
    model_->labeling.endStroke();
  }
  void editEverything() {
    paint({-10, 10, 0});
    paint({10, 10, 3});
    model_->openCase.setTitle("Renamed");
    CasePlaces places = model_->places.value();
    places.targets.push_back({"artery", kArtery, {-10, 10, 0}});
    model_->places.set(std::move(places), "target");
    model_->structures.add(kOwn);
    model_->terms.setName(kOwn, "rib");
    model_->terms.setState(kVein, LabelState::Completed);
    model_->appearance.setColor(kVein, {12, 34, 56});
    model_->appearance.setVisible(kBone, false);
    keptBefore_ = kept_->count();
  }
  /// Waits until the work was kept after the last edit of this class.
  bool waitUntilKept() {
    return until([this] { return kept_->count() > keptBefore_; });
  }
  QDialog* question() { return workspace_->findChild<QDialog*>("restoreQuestion"); }
  std::string waitForQuestion() {
    EXPECT_TRUE(until([this] { return question() && question()->isVisible(); }));
    return question() ? question()->findChild<QLabel*>("restoreText")->text().toStdString() : "";
  }
  void answer(const char* button) {
    ASSERT_TRUE(question());
    QTest::mouseClick(question()->findChild<QPushButton*>(button), Qt::LeftButton);
    ASSERT_TRUE(until([this] { return !question(); }));
  }
  void restore() {
    waitForQuestion();
    keptBefore_ = kept_->count();
    answer("restoreWork");
    ASSERT_TRUE(until([this] { return workspace_->unsavedEdit() && workspace_->isReady(); }));
  }
  void redo() {
    keptBefore_ = kept_->count();
    model_->openCase.undoStack().redo();
  }
  /// Waits until the thread that keeps work has done its jobs.
  void rest() { keeper()->thread().waitForDone(); }
  UnsavedKeeper* keeper() { return workspace_->findChild<UnsavedKeeper*>(); }

  static constexpr std::uint8_t kOwn = test::kOwnLabel;
  ui::MainWindow window_;
  PrepareWorkspace* workspace_;
  std::unique_ptr<PrepareModel> model_;

 private:
  std::unique_ptr<QSignalSpy> kept_;
  int keptBefore_ = 0;
};

/// The case as it would be saved.
PatientCase caseWithEdits(Program& program) {
  PatientCase edited = *program.model_->openCase.patient();
  if (const auto edit = program.workspace_->unsavedEdit()) edit(edited);
  if (const auto edit = program.workspace_->unpromptedEdit()) edit(edited);
  return edited;
}

void expectEqual(const PatientCase& a, const PatientCase& b) {
  EXPECT_EQ(a.ct.voxels, b.ct.voxels);
  EXPECT_EQ(a.labels.voxels, b.labels.voxels);
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.manifest.title, b.manifest.title);
  EXPECT_EQ(a.manifest.targets, b.manifest.targets);
  EXPECT_EQ(a.manifest.startPoses, b.manifest.startPoses);
  EXPECT_EQ(a.manifest.ownLabels, b.manifest.ownLabels);
  EXPECT_EQ(a.manifest.states, b.manifest.states);
  EXPECT_EQ(a.manifest.shown, b.manifest.shown);
}

class Recovery : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(writeCase(test::smallCase(), case_)); }
  void TearDown() override { EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(5000))); }

  /// The folder of kept work as a killed program leaves it: without locks.
  fs::path leftBehind() {
    fs::path copy = home_ / ("left" + std::to_string(++copies_));
    fs::copy(root_, copy, fs::copy_options::recursive);
    return copy;
  }
  /// Edits the case, and returns the folder that is left when the program is killed after the edits were kept.
  fs::path killedAfterStrokes() {
    Program program(root_);
    program.open(case_);
    program.paint({-10, 10, 0});
    EXPECT_TRUE(program.waitUntilKept());
    return leftBehind();
  }
  static std::size_t count(const fs::path& root) { return KeptFolder::foldersIn(root).size(); }

  test::TemporaryFolder home_;
  fs::path case_ = home_ / "block", root_ = home_ / "unsaved";
  int copies_ = 0;
};

TEST_F(Recovery, GivesBackTheSameCaseAfterAKill) {
  PatientCase edited;
  std::string recipe;
  fs::path left;
  {
    Program program(root_);
    program.open(case_);
    program.editEverything();
    ASSERT_TRUE(program.waitUntilKept());
    edited = caseWithEdits(program);
    recipe = textOf(program.model_->labeling.recipe());
    left = leftBehind();
  }
  EXPECT_EQ(count(root_), 0U) << "a window that is closed leaves nothing";
  Program program(left);
  program.open(case_);
  const std::string text = program.waitForQuestion();
  EXPECT_THAT(text, HasSubstr("\"Renamed\""));
  EXPECT_THAT(text, HasSubstr("2 brush strokes, title, places, names and states of structures, colors, visibility."));
  EXPECT_FALSE(program.workspace_->unsavedEdit()) << "nothing is applied without the user";
  program.restore();
  expectEqual(caseWithEdits(program), edited);
  EXPECT_EQ(textOf(program.model_->labeling.recipe()), recipe);
  EXPECT_FALSE(program.model_->openCase.undoStack().canUndo());
  ASSERT_TRUE(program.waitUntilKept());
  EXPECT_EQ(count(left), 1U) << "the restored work is still unsaved";

  program.window_.saveCase();
  ASSERT_TRUE(until([&] { return !program.workspace_->unsavedEdit() && !program.window_.tasks().isRunning(); }));
  program.rest();
  EXPECT_EQ(count(left), 0U);
  expectEqual(readCase(case_)->patient, edited);
}

TEST_F(Recovery, RestoredWorkSurvivesTheNextKill) {
  fs::path left = killedAfterStrokes();
  PatientCase edited;
  {
    Program program(left);
    program.open(case_);
    program.restore();
    program.paint({10, 10, 3});
    ASSERT_TRUE(program.waitUntilKept());
    edited = caseWithEdits(program);
    root_ = left;
    left = leftBehind();
  }
  Program program(left);
  program.open(case_);
  EXPECT_THAT(program.waitForQuestion(), HasSubstr("2 brush strokes"));
  program.restore();
  expectEqual(caseWithEdits(program), edited);
}

TEST_F(Recovery, DiscardDeletesTheWorkAndLeavesTheCase) {
  const fs::path left = killedAfterStrokes();
  Program program(left);
  program.open(case_);
  program.waitForQuestion();
  program.answer("discardWork");
  program.rest();
  EXPECT_EQ(count(left), 0U);
  EXPECT_FALSE(program.workspace_->unsavedEdit());
  EXPECT_EQ(readCase(case_)->patient.labels.voxels, test::smallCase().labels.voxels);
}

TEST_F(Recovery, LaterAsksWhenTheCaseIsOpenedAgain) {
  const fs::path left = killedAfterStrokes();
  Program program(left);
  program.open(case_);
  program.waitForQuestion();
  program.answer("later");
  EXPECT_EQ(count(left), 1U);
  program.window_.commands().action("window.case.reload")->trigger();
  EXPECT_THAT(program.waitForQuestion(), HasSubstr("1 brush stroke"));
  program.restore();
}

TEST_F(Recovery, ACaseThatWasSavedSinceThenKeepsWhatWasSaved) {
  const fs::path left = killedAfterStrokes();
  PatientCase theirs = test::smallCase();
  theirs.labels.at(40, 30, 3) = kNerve;
  theirs.manifest.description = "edited by another author";
  ASSERT_TRUE(saveCaseVersion(theirs, case_, "2026-11-30", ""));
  Program program(left);
  program.open(case_);
  EXPECT_THAT(program.waitForQuestion(), HasSubstr("The case was saved again since then."));
  program.restore();
  const PatientCase merged = caseWithEdits(program);
  EXPECT_EQ(merged.labels.at(40, 30, 3), kNerve);
  EXPECT_EQ(merged.labels.at(14, 16, 8), kArtery);
  EXPECT_EQ(merged.manifest.description, "edited by another author");
}

TEST_F(Recovery, UndoAndSaveDeleteTheKeptWork) {
  Program program(root_);
  program.open(case_);
  program.paint({-10, 10, 0});
  ASSERT_TRUE(program.waitUntilKept());
  EXPECT_EQ(count(root_), 1U);
  program.model_->openCase.undoStack().undo();
  program.rest();
  EXPECT_EQ(count(root_), 0U);
  program.redo();
  ASSERT_TRUE(program.waitUntilKept());
  program.window_.saveCase();
  ASSERT_TRUE(until([&] { return !program.workspace_->unsavedEdit() && !program.window_.tasks().isRunning(); }));
  program.rest();
  EXPECT_EQ(count(root_), 0U);
}

TEST_F(Recovery, OnlyStepsAfterTheLastSaveAreKept) {
  Program program(root_);
  program.open(case_);
  program.paint({-10, 10, 0});
  program.window_.saveCase();
  ASSERT_TRUE(until([&] { return !program.workspace_->unsavedEdit() && !program.window_.tasks().isRunning(); }));
  program.paint({10, 10, 3});
  ASSERT_TRUE(program.waitUntilKept());
  EXPECT_EQ(program.model_->labeling.recipe().steps.size(), 2U);
  const auto work = readUnsavedWork(KeptFolder::foldersIn(root_).front() / "unsaved.work");
  ASSERT_TRUE(work);
  EXPECT_EQ(work->strokes, 1) << "the recipe beside the case contains the other one";
  EXPECT_EQ(readRecipe(work->recipe)->steps.size(), 1U);
  const auto labels = program.model_->labeling.labels().voxels;
  EXPECT_EQ(withUnsavedLabels(*work, readCase(case_)->patient.labels)->voxels, labels);
  Program next(leftBehind());
  next.open(case_);
  EXPECT_THAT(next.waitForQuestion(), Not(HasSubstr("saved again"))) << "the case is as the first program saved it";
  next.restore();
  EXPECT_EQ(next.model_->labeling.labels().voxels, labels);
}

TEST_F(Recovery, AStrokeInProgressIsKeptWithItsPoints) {
  Program program(root_);
  program.open(case_);
  LabelStep step;
  step.tool = step::Paint{.radius_mm = 3};
  step.label = kArtery;
  ASSERT_TRUE(program.model_->labeling.beginStroke(step, "paint"));
  program.model_->labeling.strokeTo({-10, 10, 0});
  program.model_->labeling.strokeTo({-6, 10, 0});
  ASSERT_TRUE(program.waitUntilKept());
  const auto work = readUnsavedWork(KeptFolder::foldersIn(root_).front() / "unsaved.work");
  ASSERT_TRUE(work);
  const auto recipe = readRecipe(work->recipe);
  ASSERT_TRUE(recipe) << recipe.error().message;
  EXPECT_EQ(std::get<step::Paint>(recipe->steps.front().tool).points_mm.size(), 2U);
  program.model_->labeling.endStroke();
}

TEST_F(Recovery, TwoProgramsDoNotTakeEachOthersWork) {
  Program one(root_), two(root_);
  one.open(case_);
  one.paint({-10, 10, 0});
  ASSERT_TRUE(one.waitUntilKept());
  two.open(case_);
  two.rest();
  QTest::qWait(100);
  EXPECT_FALSE(two.question());
  two.paint({10, 10, 3});
  ASSERT_TRUE(two.waitUntilKept());
  EXPECT_EQ(count(root_), 2U);
  two.model_->openCase.undoStack().undo();
  two.rest();
  ASSERT_EQ(count(root_), 1U);
  EXPECT_FALSE(KeptFolder::take(KeptFolder::foldersIn(root_).front())) << "the other program's work is still locked";
}

TEST_F(Recovery, DamagedWorkIsSetAsideWithASentence) {
  const fs::path left = killedAfterStrokes();
  const fs::path file = KeptFolder::foldersIn(left).front() / "unsaved.work";
  fs::resize_file(file, fs::file_size(file) / 2);
  Program program(left);
  program.open(case_);
  ASSERT_TRUE(until([&] { return program.window_.errors().isVisible(); }));
  EXPECT_THAT(program.window_.errors().message().toStdString(), HasSubstr("Unsaved work could not be restored."));
  EXPECT_FALSE(program.question());
  EXPECT_FALSE(program.workspace_->unsavedEdit());
  EXPECT_EQ(count(left), 0U);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(left)) names.push_back(entry.path().filename().string());
  ASSERT_EQ(names.size(), 1U);
  EXPECT_TRUE(names.front().starts_with("damaged-"));
}

TEST_F(Recovery, WorkOnAnotherCtIsSetAside) {
  const fs::path left = killedAfterStrokes();
  PatientCase other = test::smallCase();
  other.ct.voxels[100] = 77;
  ASSERT_TRUE(writeCase(other, case_));
  Program program(left);
  program.open(case_);
  ASSERT_TRUE(until([&] { return program.window_.errors().isVisible(); }));
  EXPECT_FALSE(program.question());
  EXPECT_FALSE(program.workspace_->unsavedEdit());
  EXPECT_EQ(count(left), 0U);
  EXPECT_FALSE(fs::is_empty(left));
}

TEST_F(Recovery, OffersWorkOnACaseThatIsNotOpen) {
  const fs::path left = killedAfterStrokes();
  const fs::path other = home_ / "other";
  ASSERT_TRUE(writeCase(test::smallAttemptCase(), other));
  Program program(left);
  program.open(other);
  EXPECT_THAT(program.waitForQuestion(), HasSubstr("Restore opens this case."));
  program.restore();
  EXPECT_EQ(program.window_.current().folder.toStdString(), case_.string());
  EXPECT_EQ(program.model_->labeling.labels().at(14, 16, 8), kArtery);
  EXPECT_FALSE(program.question()) << "the user is asked once";
}

TEST_F(Recovery, AnImportThatWasNeverSavedIsKeptWithItsCt) {
  PatientCase edited;
  fs::path left;
  {
    Program program(root_);
    Q_EMIT program.workspace_->caseMade(std::make_shared<const PatientCase>(test::smallCase()));
    ASSERT_TRUE(program.waitUntilKept());
    program.editEverything();
    ASSERT_TRUE(program.waitUntilKept());
    edited = caseWithEdits(program);
    left = leftBehind();
  }
  Program program(left);
  program.open(case_);
  EXPECT_THAT(program.waitForQuestion(), HasSubstr("the CT, since the case was never saved"));
  program.restore();
  EXPECT_TRUE(program.window_.current().folder.isEmpty());
  expectEqual(caseWithEdits(program), edited);
  ASSERT_TRUE(program.waitUntilKept());
  EXPECT_EQ(count(left), 1U);
}

TEST_F(Recovery, ADamagedCopyOfAnImportIsSetAside) {
  fs::path left;
  {
    Program program(root_);
    Q_EMIT program.workspace_->caseMade(std::make_shared<const PatientCase>(test::smallCase()));
    ASSERT_TRUE(program.waitUntilKept());
    left = leftBehind();
  }
  const fs::path ct = KeptFolder::foldersIn(left).front() / "case" / "ct.nrrd";
  fs::resize_file(ct, fs::file_size(ct) / 2);
  Program program(left);
  program.open(case_);
  program.waitForQuestion();
  program.answer("restoreWork");
  ASSERT_TRUE(until([&] { return program.window_.errors().isVisible(); }));
  EXPECT_EQ(program.window_.current().folder.toStdString(), case_.string()) << "the open case stays";
  EXPECT_EQ(count(left), 0U);
  EXPECT_FALSE(fs::is_empty(left));
}

TEST_F(Recovery, ColorsAndVisibilityAreUnsavedAlsoBeforeTheVoxelsAreCounted) {
  Program program(root_);
  program.open(case_);
  program.model_->appearance.setColor(kOther, {12, 34, 56});
  program.model_->appearance.setVisible(kOther, false);
  ASSERT_THAT(program.model_->structures.labels(), Not(testing::Contains(kOther))) << "not listed";
  const PatientCase edited = caseWithEdits(program);
  EXPECT_EQ(edited.colors.at(kOther), (LabelColor{12, 34, 56}));
  EXPECT_FALSE(edited.manifest.shown.at(kOther).visible);
}

TEST_F(Recovery, ImportedLabelsAreKeptAsAWhole) {
  PatientCase labeled = test::smallAttemptCase();
  fs::path left;
  {
    Program program(root_);
    program.open(case_);
    ui::CaseOrigin origin = program.model_->openCase.origin();
    origin.labelsReplaced = true;
    program.workspace_->setOrigin(origin);
    program.workspace_->setCase(std::make_shared<const PatientCase>(labeled));
    ASSERT_TRUE(program.waitUntilKept());
    left = leftBehind();
  }
  Program program(left);
  program.open(case_);
  EXPECT_THAT(program.waitForQuestion(), HasSubstr("imported labels"));
  program.restore();
  EXPECT_EQ(program.model_->labeling.labels().voxels, labeled.labels.voxels);
}

TEST_F(Recovery, AFolderThatCannotBeWrittenGivesASentence) {
  std::ofstream(root_) << "in the way";
  Program program(root_);
  program.open(case_);
  program.paint({-10, 10, 0});
  ASSERT_TRUE(until([&] { return program.workspace_->statusText().startsWith("Unsaved work cannot be kept"); }))
      << program.workspace_->statusText().toStdString();
}

/// Runs in a program of its own, which SurvivesARealKill kills.
TEST(KilledProgram, DISABLED_Draws) {
  Program program(std::getenv(kChildRoot));
  program.open(std::getenv(kChildCase));
  program.paint({-10, 10, 0});
  ASSERT_TRUE(program.waitUntilKept());
  std::ofstream(fs::path(std::getenv(kChildRoot)) / "kept") << "kept";
  QTest::qWait(60'000);
}

TEST_F(Recovery, SurvivesARealKill) {
  QProcess child;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(kChildCase, QString::fromStdString(case_.string()));
  environment.insert(kChildRoot, QString::fromStdString(root_.string()));
  child.setProcessEnvironment(environment);
  child.start(QCoreApplication::applicationFilePath(),
              {"--gtest_also_run_disabled_tests", "--gtest_filter=KilledProgram.DISABLED_Draws"});
  ASSERT_TRUE(until([&] { return fs::exists(root_ / "kept"); })) << child.readAll().toStdString();
  {
    Program program(root_);
    program.open(case_);
    program.rest();
    QTest::qWait(100);
    EXPECT_FALSE(program.question()) << "the other program still runs";
  }
  child.kill();
  ASSERT_TRUE(child.waitForFinished());
  Program program(root_);
  program.open(case_);
  program.restore();
  EXPECT_EQ(program.model_->labeling.labels().at(14, 16, 8), kArtery);
}

}  // namespace
}  // namespace insonate::prepare
