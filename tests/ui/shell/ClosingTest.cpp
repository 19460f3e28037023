#include "Waiting.h"

#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QImage>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest/QTest>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>

namespace {

using namespace insonate;

/// Lifetime of the window when it is closed: while the case is read, while the first scene and the surfaces are made,
/// while images arrive.
class Closing : public testing::TestWithParam<int> {};

TEST_P(Closing, NeitherHangsNorCrashes) {
  const QTemporaryDir home;
  const QString folder = test::writtenSmallCase(home, "block");
  auto window = std::make_unique<ui::MainWindow>();
  window->addWorkspace("train", "Train", "train", new train::TrainWorkspace);
  window->showWorkspace("train");
  window->show();
  window->open(folder);
  QTest::qWait(GetParam());
  EXPECT_TRUE(window->close());
  EXPECT_FALSE(window->isVisible());
  window.reset();
  EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(5000)));
}

TEST_P(Closing, GoesWithoutBeingClosed) {
  const QTemporaryDir home;
  ui::MainWindow window;
  window.addWorkspace("train", "Train", "train", new train::TrainWorkspace);
  window.showWorkspace("train");
  window.show();
  window.open(test::writtenSmallCase(home, "block"));
  QTest::qWait(GetParam());
}

INSTANTIATE_TEST_SUITE_P(After, Closing, testing::Values(0, 20, 60, 150, 400, 1000, 2500));

/// A window in which something is being done.
class ClosingAtWork : public testing::Test {
 protected:
  void SetUp() override {
    window = std::make_unique<ui::MainWindow>();
    train = new train::TrainWorkspace;
    window->addWorkspace("train", "Train", "train", train);
    window->showWorkspace("train");
    window->show();
  }
  void TearDown() override {
    window.reset();
    EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(5000)));
  }

  /// Works until it is cancelled or let go.
  void work(ui::TaskBar::WhenClosed whenClosed, ui::TaskBar::StartedBy startedBy = ui::TaskBar::StartedBy::User) {
    window->tasks().run<bool>(
        "Importing a CT",
        [this](const Progress& progress) -> Result<bool> {
          while (!letGo)
            if (!report(progress, "reading", 0.5)) return fail(std::string(kCancelled));
          return true;
        },
        [](const Result<bool>&) {}, whenClosed, startedBy);
  }
  QAction* action(const QString& text) {
    for (auto* action : window->findChildren<QAction*>())
      if (action->text() == text) return action;
    return nullptr;
  }
  QDialog* question() { return window->findChild<QDialog*>(); }
  void press(const QString& text) {
    for (auto* button : question()->findChildren<QPushButton*>())
      if (button->text() == text) return button->click();
    FAIL() << "no button " << text.toStdString();
  }
  void openCase() {
    window->open(test::writtenSmallCase(home, "block"));
    ASSERT_TRUE(test::waitUntil([&] { return window->isReady(); }, test::kPatience_ms))
        << window->statusText().toStdString();
  }

  QTemporaryDir home;
  std::unique_ptr<ui::MainWindow> window;
  train::TrainWorkspace* train = nullptr;
  std::atomic<bool> letGo = false;
};

TEST_F(ClosingAtWork, AsksBeforeWorkIsLost) {
  work(ui::TaskBar::WhenClosed::Ask);
  EXPECT_FALSE(window->close());
  ASSERT_TRUE(question());
  EXPECT_TRUE(window->isVisible());
  EXPECT_FALSE(window->close()) << "asked once";
  EXPECT_EQ(window->findChildren<QDialog*>().size(), 1);
  press("Cancel");
  EXPECT_TRUE(window->tasks().isRunning());
  EXPECT_TRUE(test::waitUntil([&] { return !question(); }));
  EXPECT_FALSE(window->close());
  press("Stop and close");
  EXPECT_TRUE(test::waitUntil([&] { return !window->isVisible(); }));
}

TEST_F(ClosingAtWork, AsksBeforeAnUnsavedCaseIsLost) {
  auto made = std::make_shared<PatientCase>(test::smallCase());
  Q_EMIT train->caseMade(made);
  EXPECT_FALSE(window->close());
  ASSERT_TRUE(question());
  press("Cancel");
  EXPECT_TRUE(test::waitUntil([&] { return !question(); }));
  EXPECT_TRUE(window->isVisible());
  EXPECT_FALSE(window->close());
  press("Close without saving");
  EXPECT_TRUE(test::waitUntil([&] { return !window->isVisible(); }));
}

/// A check of the case runs after most changes, and an author saves without watching for it.
TEST_F(ClosingAtWork, SavingDoesNotWaitForTheCheckOfTheCase) {
  Q_EMIT train->caseMade(std::make_shared<PatientCase>(test::smallCase()));
  work(ui::TaskBar::WhenClosed::Stop, ui::TaskBar::StartedBy::Program);
  QTest::keyClick(window.get(), Qt::Key_Escape);
  EXPECT_TRUE(window->tasks().isRunning()) << "Esc was not meant for it";
  auto* save = action("Save case");
  ASSERT_TRUE(save);
  ASSERT_TRUE(save->isEnabled());
  bool isAsked = false;
  QTimer::singleShot(200, window.get(), [&] {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QFileDialog*>(widget)) isAsked = true, dialog->reject();
  });
  save->trigger();
  EXPECT_TRUE(isAsked) << "for the folder";
}

TEST_F(ClosingAtWork, SavingSaysForWhatItHasToWait) {
  Q_EMIT train->caseMade(std::make_shared<PatientCase>(test::smallCase()));
  work(ui::TaskBar::WhenClosed::Ask);
  auto* save = action("Save case");
  ASSERT_TRUE(save && save->isEnabled());
  save->trigger();
  EXPECT_EQ(window->statusText(), "Not saved: wait until \"Importing a CT\" has ended, then save again.");
  EXPECT_TRUE(window->tasks().isRunning());
  letGo = true;
}

TEST_F(ClosingAtWork, AnotherCaseTakesAnUnsavedOnesPlaceOnlyWhenToldTo) {
  const auto made = std::make_shared<const PatientCase>(test::smallCase());
  const QString other = test::writtenSmallCase(home, "block");
  Q_EMIT train->caseMade(made);
  for (const auto& another :
       {std::function<void()>([&] { window->open(other); }), std::function<void()>([&] { window->openTextbook(); })}) {
    another();
    ASSERT_TRUE(question());
    EXPECT_FALSE(window->tasks().isRunning());
    press("Cancel");
    EXPECT_TRUE(test::waitUntil([&] { return !question(); }));
  }
  EXPECT_EQ(window->current().patient, made);
  window->open(other);
  press("Continue without saving");
  EXPECT_TRUE(test::waitUntil([&] { return window->current().folder == other; }, test::kPatience_ms));
  window->open(other);
  EXPECT_FALSE(question()) << "this one is on disk";
}

TEST_F(ClosingAtWork, AnUnsavedCaseIsSavedBeforeAnotherTakesItsPlace) {
  PatientCase imported = test::smallCase();
  imported.manifest.title = "Imported";
  const QString other = test::writtenSmallCase(home, "block"), target = home.filePath("kept");
  Q_EMIT train->caseMade(std::make_shared<const PatientCase>(imported));
  window->open(other);
  ASSERT_TRUE(question());
  test::answerFileDialog(*window, target);
  press("Save case as ...");
  EXPECT_TRUE(test::waitUntil([&] { return window->current().folder == other; }, test::kPatience_ms));
  const auto kept = readCase(target.toStdString());
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_EQ(kept->patient.manifest.title, "Imported");
}

TEST_F(ClosingAtWork, AnotherCaseStopsAnImportOnlyWhenToldTo) {
  work(ui::TaskBar::WhenClosed::Ask);
  const QString other = test::writtenSmallCase(home, "block");
  window->open(other);
  ASSERT_TRUE(question());
  EXPECT_EQ(window->tasks().title(), "Importing a CT");
  press("Stop and continue");
  EXPECT_TRUE(test::waitUntil([&] { return window->current().folder == other; }, test::kPatience_ms));
}

TEST_F(ClosingAtWork, ControlSSavesInEveryWorkspace) {
  window->addWorkspace("review", "Review", "review", new ui::EmptyWorkspace({"review", "Nothing yet", {}, {}, {}}));
  QApplication::setActiveWindow(window.get());
  for (const char* room : {"train", "review"}) {
    Q_EMIT train->caseMade(std::make_shared<const PatientCase>(test::smallCase()));
    window->showWorkspace(room);
    const QString target = home.filePath(room);
    test::answerFileDialog(*window, target);
    ASSERT_TRUE(test::waitUntil([&] { return window->commands().action("window.case.save")->isEnabled(); }));
    QTest::keyClick(window->focusWidget() ? window->focusWidget() : window.get(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(test::waitUntil([&] { return window->current().folder == target; }, test::kPatience_ms)) << room;
    EXPECT_FALSE(window->commands().action("window.case.save")->isEnabled()) << "nothing to save";
  }
}

TEST_F(ClosingAtWork, TheQuestionGoesWithTheWork) {
  work(ui::TaskBar::WhenClosed::Ask);
  EXPECT_FALSE(window->close());
  letGo = true;
  EXPECT_TRUE(test::waitUntil([&] { return !question(); }));
  EXPECT_TRUE(window->isVisible());
  EXPECT_TRUE(window->close());
}

TEST_F(ClosingAtWork, AsksAboutWhatTheWorkMade) {
  window->tasks().run<bool>(
      "Importing a CT",
      [this](const Progress& progress) -> Result<bool> {
        while (!letGo) report(progress, "reading", 0.5);
        return true;
      },
      [this](const Result<bool>&) { Q_EMIT train->caseMade(std::make_shared<PatientCase>(test::smallCase())); },
      ui::TaskBar::WhenClosed::Ask);
  EXPECT_FALSE(window->close());
  EXPECT_TRUE(question()->findChild<QPushButton*>("keep"));
  letGo = true;
  ASSERT_TRUE(test::waitUntil([&] { return question() && question()->findChild<QPushButton*>("save"); }));
  press("Close without saving");
  EXPECT_TRUE(test::waitUntil([&] { return !window->isVisible(); }));
}

TEST_F(ClosingAtWork, DoesNotAskWhereNothingIsLost) {
  work(ui::TaskBar::WhenClosed::Stop);
  EXPECT_TRUE(window->close());
}

TEST_F(ClosingAtWork, AClipIsWrittenAsAWholeOrNotAtAll) {
  openCase();
  for (const int wait_ms : {0, 3, 30, 3000}) {
    const QString folder = home.filePath(QString("clip-%1").arg(wait_ms));
    train->saveClip(folder.toStdString());
    EXPECT_TRUE(window->tasks().asksWhenClosed());
    if (wait_ms > 0) QTest::qWait(wait_ms);
    window->tasks().cancel();
    EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(1000)));
    EXPECT_FALSE(QDir(folder + ".part").exists());
    EXPECT_TRUE(!QDir(folder).exists() || !QDir(folder).entryList({"*.png"}).isEmpty());
    EXPECT_TRUE(wait_ms < 3000 || QDir(folder).exists());
  }
  train->saveClip(home.filePath("last").toStdString());
  train->saveImage(home.filePath("last.png").toStdString());
  window->closeAtOnce();
  EXPECT_FALSE(window->isVisible());
  window.reset();
  EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(5000)));
  EXPECT_FALSE(QDir(home.filePath("last.part")).exists());
  EXPECT_FALSE(QImage(home.filePath("last.png")).isNull()) << "a picture that was begun is whole";
}

TEST_F(ClosingAtWork, AClipInOneFileIsWrittenAsAWholeOrNotAtAll) {
  openCase();
  QTemporaryDir folder;
  for (const char* ending : {"webm", "dcm"})
    for (const int wait_ms : {0, 10, 3000}) {
      const QString file = folder.filePath(QString("clip-%1.%2").arg(wait_ms).arg(ending));
      train->saveClip(file.toStdString());
      EXPECT_TRUE(window->tasks().asksWhenClosed());
      if (wait_ms > 0) QTest::qWait(wait_ms);
      window->tasks().cancel();
      EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(1000)));
      EXPECT_TRUE(wait_ms < 3000 || QFile::exists(file)) << file.toStdString();
      EXPECT_TRUE(QDir(folder.path()).entryList({".*"}, QDir::Files | QDir::Hidden).isEmpty()) << "no part is left";
    }
}

TEST_F(ClosingAtWork, ACaseIsSavedAsAWholeOrNotAtAll) {
  const QString folder = home.filePath("block");
  for (const int wait_ms : {0, 1, 5, 20, 200}) {
    const QString target = home.filePath(QString("saved-%1").arg(wait_ms));
    ui::TaskBar tasks;
    ui::CaseLoader loader(tasks, &tasks);
    loader.save(std::make_shared<PatientCase>(test::smallCase()), target);
    if (wait_ms > 0) QTest::qWait(wait_ms);
    tasks.cancel();
    EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(5000)));
    EXPECT_TRUE(!QDir(target).exists() || readCase(target.toStdString())) << wait_ms;
  }
}

TEST_F(ClosingAtWork, AnImportIsLeftAtAnyMoment) {
  const QString folder = home.filePath("dicom");
  ASSERT_TRUE(writeDicomSeries(test::smallCase().ct, folder.toStdString(), {.seed = "closing"}));
  for (const int wait_ms : {0, 5, 30, 120}) {
    auto other = std::make_unique<ui::MainWindow>();
    other->addWorkspace("train", "Train", "train", new train::TrainWorkspace);
    other->show();
    other->open(folder);
    if (wait_ms > 20 && test::waitUntil([&] { return other->findChild<QDialog*>() != nullptr; }))
      other->findChild<QDialog*>()->accept();
    if (wait_ms > 0) QTest::qWait(wait_ms);
    other->closeAtOnce();
    EXPECT_FALSE(other->isVisible());
  }
}

}  // namespace
