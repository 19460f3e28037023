#include "AttemptWindow.h"

namespace insonate::train {
namespace {

constexpr int kLonger_ms = 300;  ///< than an image and its scene take

using TrainSleep = AttemptWindow;

TEST_F(TrainSleep, HiddenItMakesNoPicturesAndGoesOnWhenShown) {
  openCase();
  settle();
  workspace_->hide();
  QTest::qWait(kLonger_ms);  // an image that had begun when the workspace was hidden still arrives
  const auto before = session_->shown();
  session_->move(HandAxis::Lateral, 3);
  QTest::qWait(kLonger_ms);
  EXPECT_EQ(session_->shown(), before) << "the last picture stays";
  workspace_->show();
  settle();
  EXPECT_NE(session_->shown(), before);
}

TEST_F(TrainSleep, ACaseThatComesWhileItIsHiddenIsImagedOnceItIsShown) {
  workspace_->hide();
  workspace_->setCase(patient());
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_->handReady(); }, kPatience_ms));
  QTest::qWait(kLonger_ms);
  EXPECT_EQ(session_->status().scenesBuilt, 0);
  EXPECT_EQ(session_->shown(), nullptr);
  workspace_->show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms))
      << workspace_->statusText().toStdString();
}

TEST_F(TrainSleep, AnAttemptGoesOnBehindAnotherWorkspace) {
  openWide();
  start();
  workspace_->hide();
  session_->move(HandAxis::Lateral, 3);
  settle();
  EXPECT_TRUE(attempt_->isRunning());
}

}  // namespace
}  // namespace insonate::train
