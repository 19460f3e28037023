#include "NeedleWindow.h"
#include "attempt/AttemptControl.h"
#include "attempt/SyringeView.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/ui/Attempts.h>

#include <gmock/gmock.h>

#include <QDir>
#include <QLabel>

namespace insonate::train {
namespace {

using State = AttemptControl::State;

/// An attempt as a trainee makes it, by keys and buttons.
class TrainAttempt : public NeedleWindow {
 protected:
  void SetUp() override {
    NeedleWindow::SetUp();
    QDir(folder()).removeRecursively();
    attempt_ = workspace_->findChild<AttemptControl*>();
    ASSERT_TRUE(attempt_);
  }

  static QString folder() { return ui::attemptsFolder(); }
  static QStringList files() { return QDir(folder()).entryList(QDir::Files); }
  Result<AttemptRecording> recorded() {
    const QStringList all = files();
    if (all.size() != 1) return fail(std::to_string(all.size()) + " files");
    return AttemptRecording::open(QDir(folder()).filePath(all.front()).toStdString());
  }
  QString text(const char* label) { return child<QLabel>(label)->text(); }
  bool shown(const char* widget) { return child<QWidget>(widget)->isVisible(); }
  void start() {
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); })) << workspace_->statusText().toStdString();
  }
  void finish() {
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt_->state() == State::Over; }));
  }

  AttemptControl* attempt_ = nullptr;
};

TEST_F(TrainAttempt, AWholeOneByKeysIsGuidedScoredAndKept) {
  openWide();
  EXPECT_TRUE(shown("attemptStart"));
  EXPECT_FALSE(shown("attemptStrip"));
  start();
  EXPECT_FALSE(shown("attemptStart"));
  EXPECT_TRUE(shown("attemptStrip"));
  EXPECT_TRUE(text("attemptDue").contains("Position the patient")) << text("attemptDue").toStdString();

  auto* positions = child<QComboBox>("attemptPosition");
  const int tilted = positions->findText("Trendelenburg 15");
  ASSERT_GE(tilted, 0);
  positions->setCurrentIndex(tilted);
  Q_EMIT positions->activated(tilted);
  EXPECT_EQ(session_->tissue().body.tilt_deg, 15);
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Find the vein"); }));
  for (int i = 0; i < 8; ++i) key(Qt::Key_Plus);
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Puncture the skin"); })) << "pressed for two seconds";
  for (int i = 0; i < 8; ++i) key(Qt::Key_Minus);

  overTheVein();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  EXPECT_TRUE(waitFor([&] { return text("attemptNeedle").contains("in the vein"); }));
  EXPECT_EQ(text("attemptVein"), "vein 1");
  key(Qt::Key_B);
  EXPECT_TRUE(child<QPushButton>("attemptDraw")->isChecked());
  auto* syringe = workspace_->findChild<SyringeView*>();
  EXPECT_TRUE(waitFor([&] { return syringe->content() == SyringeView::Content::DarkBlood && syringe->level() > 0.1; }));
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Freeze and look"); }));
  key(Qt::Key_B);
  key(Qt::Key_Space);
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Withdraw"); }));
  key(Qt::Key_Space);
  type("needle_depth", "-5");
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("All steps are done"); }));
  EXPECT_TRUE(text("attemptNeedle").contains("needle used"));
  key(Qt::Key_U);
  EXPECT_TRUE(waitFor([&] { return text("attemptNeedle").contains("needle new"); }));
  EXPECT_EQ(syringe->content(), SyringeView::Content::Nothing);
  finish();

  EXPECT_TRUE(text("attemptHeadline").contains("of 100: the vein was reached"))
      << text("attemptHeadline").toStdString();
  QString reviewed;
  QObject::connect(workspace_.get(), &TrainWorkspace::attemptWanted, [&](const QString& file) { reviewed = file; });
  child<QPushButton>("attemptReview")->click();
  EXPECT_EQ(QFileInfo(reviewed).absolutePath(), QFileInfo(folder()).absoluteFilePath());
  const auto recording = recorded();
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->status(), AttemptStatus::Completed);
  EXPECT_EQ(recording->header().procedure, "internal_jugular");
  EXPECT_EQ(recording->header().caseHash.size(), 16U);
  EXPECT_EQ(*recording->metricsUntil(), attempt_->view().metrics) << "replayed to the last bit";
  std::vector<AttemptEvent> events;
  EXPECT_TRUE(recording->play(recording->end_us(), [&](const AttemptRecording::Entry& entry) {
    if (const auto* event = std::get_if<AttemptEvent>(&entry)) events.push_back(*event);
  }));
  EXPECT_EQ(events, attempt_->view().events);
  child<QPushButton>("attemptLeave")->click();
  EXPECT_TRUE(shown("attemptStart"));
}

TEST_F(TrainAttempt, WhatWentWrongIsSaidWithWhatToDo) {
  openWide();
  start();
  overTheVein();
  type("needle_depth", "22");
  EXPECT_TRUE(waitFor([&] { return text("attemptFindings").contains("through the back wall"); }));
  EXPECT_TRUE(text("attemptFindings").contains("Major")) << text("attemptFindings").toStdString();
  EXPECT_TRUE(waitFor([&] { return text("attemptNeedle").contains("wrong place"); }));
  key(Qt::Key_U);
  EXPECT_TRUE(workspace_->statusText().contains("Withdraw the needle"));
  child<QPushButton>("attemptAbandon")->click();
  ASSERT_TRUE(waitFor([&] { return attempt_->state() == State::Over; }));
  EXPECT_EQ(text("attemptHeadline"), "Abandoned");
  EXPECT_EQ(recorded()->status(), AttemptStatus::Abandoned);
}

TEST_F(TrainAttempt, ATestIsSilentAndWithoutTheCt) {
  openWide();
  attempt_->setMode(AttemptMode::Test);
  start();
  EXPECT_FALSE(shown("attemptDue"));
  EXPECT_FALSE(shown("attemptVein"));
  EXPECT_FALSE(shown("sceneTab"));
  key(Qt::Key_C);
  EXPECT_TRUE(workspace_->statusText().contains("without the CT"));
  overTheVein();
  said_.clear();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  QTest::qWait(150);
  EXPECT_EQ(heard("Vein"), 0);
  EXPECT_TRUE(text("attemptNeedle").contains("in tissue"));
  EXPECT_FALSE(text("needleWords").contains("vein")) << text("needleWords").toStdString();
  finish();
  EXPECT_TRUE(shown("sceneTab"));
}

TEST_F(TrainAttempt, AgainBeginsAnotherAndLeavingTheCaseKeepsWhatWasMade) {
  openWide();
  start();
  overTheVein();
  child<QPushButton>("attemptAgain")->click();
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning() && files().size() >= 2; })) << files().join(' ').toStdString();
  EXPECT_FALSE(hands().needleHand()) << "laid down";
  EXPECT_EQ(files().filter(".part").size(), 1);
  workspace_->setCase(nullptr);
  EXPECT_EQ(attempt_->state(), State::Idle);
  EXPECT_EQ(files().size(), 2);
  EXPECT_TRUE(files().filter(".part").isEmpty()) << "both are whole";
  openWide();
  start();
  workspace_ = nullptr;
  EXPECT_EQ(files().size(), 3);
  EXPECT_TRUE(files().filter(".part").isEmpty());
}

}  // namespace
}  // namespace insonate::train
