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
  const auto before = model_->live.shown();
  model_->motion.move(HandAxis::Lateral, 3);
  QTest::qWait(kLonger_ms);
  EXPECT_EQ(model_->live.shown(), before) << "the last picture stays";
  workspace_->show();
  settle();
  EXPECT_NE(model_->live.shown(), before);
}

TEST_F(TrainSleep, ACaseThatComesWhileItIsHiddenIsImagedOnceItIsShown) {
  workspace_->hide();
  workspace_->setCase(patient());
  ASSERT_TRUE(QTest::qWaitFor([&] { return model_->motion.isReady(); }, kPatience_ms));
  QTest::qWait(kLonger_ms);
  EXPECT_EQ(model_->live.status().scenesBuilt, 0);
  EXPECT_EQ(model_->live.shown(), nullptr);
  workspace_->show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms))
      << workspace_->statusText().toStdString();
}

TEST_F(TrainSleep, AnAttemptGoesOnBehindAnotherWorkspace) {
  openWide();
  start();
  workspace_->hide();
  model_->motion.move(HandAxis::Lateral, 3);
  settle();
  EXPECT_TRUE(attempt_->isRunning());
}

}  // namespace
}  // namespace insonate::train
