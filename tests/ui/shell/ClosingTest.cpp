#include "Waiting.h"

#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QtTest/QTest>
#include <memory>

namespace {

using namespace insonate;

/// How long the window has lived when it is closed: while the case is read, while the first scene and the surfaces are
/// made, while pictures come.
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

}  // namespace
