#include "Waiting.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QAction>
#include <QCoreApplication>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>

namespace insonate {
namespace {

class Reviewing final : public ui::Workspace {
 public:
  void setCase(std::shared_ptr<const PatientCase>) override {}
  bool canOpenAttempts() const override { return true; }
  void openAttempt(const QString& file) override { opened << file; }
  QStringList opened;
};

class AttemptFiles : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    window.addWorkspace("train", "Train", "train", train);
    window.addWorkspace("review", "Review", "review", review);
    window.show();
  }
  QString recording(const QString& name) const {
    const QString file = home.filePath(name);
    auto recorder = AttemptRecorder::start(file.toStdString(), {});
    EXPECT_TRUE(recorder && (*recorder)->finish(AttemptStatus::Completed));
    return file;
  }
  QString text(const QString& name) const {
    QFile file(home.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("words");
    return file.fileName();
  }

  QTemporaryDir home;
  ui::MainWindow window;
  ui::EmptyWorkspace* train = new ui::EmptyWorkspace({"train", "Train", {}, {}, {}});
  Reviewing* review = new Reviewing;
};

TEST_F(AttemptFiles, AreKnownByNameAndByHowTheyBegin) {
  EXPECT_TRUE(ui::isAttemptFile(recording("first")));
  EXPECT_TRUE(ui::isAttemptFile(recording("second.attempt")));
  EXPECT_TRUE(ui::isAttemptFile(text("garbage.attempt"))) << "so that its trouble is told as an attempt's";
  EXPECT_TRUE(ui::isAttemptFile(text("cut.attempt.part")));
  EXPECT_FALSE(ui::isAttemptFile(text("words.txt")));
  EXPECT_FALSE(ui::isAttemptFile(text("empty")));
  EXPECT_FALSE(ui::isAttemptFile(home.path()));
  EXPECT_FALSE(ui::isAttemptFile(home.filePath("none.attempt")));
}

TEST_F(AttemptFiles, OpenWhereAttemptsAreShown) {
  const QString file = recording("one");
  window.open(file);
  EXPECT_EQ(review->opened, QStringList{file});
  EXPECT_EQ(window.currentId(), "review");

  window.showWorkspace("train");
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &enter);
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &drop);
  EXPECT_EQ(review->opened.size(), 2);
  EXPECT_EQ(window.currentId(), "review");

  window.showWorkspace("train");
  Q_EMIT train->attemptRequested(file);
  EXPECT_EQ(review->opened.size(), 3);
  EXPECT_EQ(window.currentId(), "review");
}

TEST_F(AttemptFiles, AWorkspaceGetsTheCaseThatItWants) {
  Q_EMIT review->caseRequested("small-vein");
  EXPECT_TRUE(window.tasks().isRunning());
  EXPECT_EQ(window.tasks().title(), "Opening the built-in case");
  ASSERT_TRUE(test::waitUntil([&] { return !window.tasks().isRunning(); }));
  EXPECT_EQ(window.caseTitle(), "Small jugular vein");
  Q_EMIT review->caseRequested(home.path());
  EXPECT_TRUE(window.tasks().isRunning());
}

TEST_F(AttemptFiles, ACaseThatIsNotSavedIsAskedAboutBeforeThatOfAnAttemptTakesItsPlace) {
  const auto made = std::make_shared<const PatientCase>(test::smallCase());
  Q_EMIT train->caseMade(made);
  Q_EMIT review->caseRequested("textbook");
  EXPECT_FALSE(window.tasks().isRunning());
  auto* keep = window.findChild<QPushButton*>("keep");
  ASSERT_TRUE(keep && keep->isVisible());
  keep->click();
  EXPECT_FALSE(window.tasks().isRunning());
  EXPECT_EQ(window.current().patient, made);
}

TEST(AttemptMenu, IsThereOnlyWhereAttemptsAreShown) {
  ui::MainWindow window;
  EXPECT_FALSE(window.commands().action("window.attempt.open")->isVisible());
  window.addWorkspace("train", "Train", "train", new ui::EmptyWorkspace({"train", "Train", {}, {}, {}}));
  EXPECT_FALSE(window.commands().action("window.attempt.open")->isVisible());
  window.addWorkspace("review", "Review", "review", new Reviewing);
  EXPECT_TRUE(window.commands().action("window.attempt.open")->isVisible());
}

}  // namespace
}  // namespace insonate
