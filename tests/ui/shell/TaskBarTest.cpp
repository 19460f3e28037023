#include "Waiting.h"

#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QThread>
#include <QtTest/QTest>
#include <atomic>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <thread>

namespace {

using namespace insonate;
using namespace std::chrono_literals;
using test::waitUntil;
using ui::TaskBar;

/// Works until it is asked to stop.
Result<int> endless(const Progress& progress) {
  while (report(progress, "turning", 0.25)) std::this_thread::sleep_for(5ms);
  return fail(std::string(kCancelled));
}

TEST(TaskBar, WorksOnAnotherThreadAndDeliversOnThisOne) {
  TaskBar bar;
  std::optional<int> answer;
  QThread* worker = nullptr;
  bar.run<int>(
      "Counting",
      [&worker](const Progress&) -> Result<int> {
        worker = QThread::currentThread();
        return 42;
      },
      [&](Result<int> result) {
        answer = *result;
        EXPECT_EQ(QThread::currentThread(), bar.thread());
      });
  EXPECT_TRUE(bar.isRunning());
  EXPECT_FALSE(answer) << "never from within run()";
  ASSERT_TRUE(waitUntil([&] { return answer.has_value(); }));
  EXPECT_EQ(*answer, 42);
  EXPECT_NE(worker, bar.thread());
  EXPECT_FALSE(bar.isRunning());
  EXPECT_TRUE(bar.isHidden());
}

TEST(TaskBar, ShowsWhatIsDoneAndHowFarItIs) {
  TaskBar bar;
  bar.run<int>("Turning the neck", endless, [](Result<int>) {});
  EXPECT_TRUE(bar.isHidden()) << "what is done at once moves nothing";
  ASSERT_TRUE(waitUntil([&] { return bar.isVisible(); }));
  auto* progress = bar.findChild<QProgressBar*>();
  ASSERT_TRUE(waitUntil([&] { return progress->value() > 0; }));
  EXPECT_EQ(progress->value(), progress->maximum() / 4);
  QStringList texts;
  for (const QLabel* label : bar.findChildren<QLabel*>()) texts << label->text();
  EXPECT_TRUE(texts.contains("Turning the neck"));
  EXPECT_TRUE(texts.contains("turning"));
}

TEST(TaskBar, AJobThatIsOneStepIsNamedOnce) {
  TaskBar bar;
  bar.run<int>("turning", endless, [](Result<int>) {});
  ASSERT_TRUE(waitUntil([&] { return bar.isVisible(); }));
  int said = 0;
  for (const QLabel* label : bar.findChildren<QLabel*>()) said += label->isVisible() && label->text() == "turning";
  EXPECT_EQ(said, 1);
}

TEST(TaskBar, CancelAnswersAtOnceAndEndsTheWork) {
  TaskBar bar;
  std::optional<std::string> answer;
  bar.run<int>("Turning", endless, [&](Result<int> result) { answer = result ? "no error" : result.error().message; });
  QTest::qWait(50);
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer, kCancelled);
  EXPECT_FALSE(bar.isRunning());
  EXPECT_TRUE(ui::waitForJobs(1000ms));
}

TEST(TaskBar, CancelDoesNotWaitForWorkThatDoesNotListen) {
  TaskBar bar;
  std::atomic<bool> release = false;
  int answers = 0;
  bar.run<int>(
      "Deaf",
      [&release](const Progress&) -> Result<int> {
        while (!release) std::this_thread::sleep_for(1ms);
        return 1;
      },
      [&](Result<int>) { ++answers; });
  bar.cancel();
  EXPECT_EQ(answers, 1);
  EXPECT_FALSE(ui::waitForJobs(1ms));
  release = true;
  EXPECT_TRUE(ui::waitForJobs(5000ms));
  QTest::qWait(100);
  EXPECT_EQ(answers, 1) << "what it yields is not delivered any more";
}

TEST(TaskBar, ANewJobCancelsTheOneBefore) {
  TaskBar bar;
  QStringList answers;
  bar.run<int>("First", endless, [&](Result<int> result) { answers << (result ? "first" : "first cancelled"); });
  bar.run<int>(
      "Second", [](const Progress&) -> Result<int> { return 2; }, [&](Result<int>) { answers << "second"; });
  ASSERT_TRUE(waitUntil([&] { return answers.size() == 2; }));
  EXPECT_EQ(answers, QStringList({"first cancelled", "second"}));
}

/// A menu that was gray during the user's job stayed gray during the check that followed.
TEST(TaskBar, WhoStartedAJobIsKnownWhenItBegins) {
  TaskBar bar;
  std::vector<bool> waits;
  QObject::connect(&bar, &TaskBar::runningChanged, [&](bool running) {
    if (running) waits.push_back(bar.isUserWaiting());
  });
  bar.run<int>("Opening", endless, [](Result<int>) {});
  bar.run<int>(
      "Checking", endless, [](Result<int>) {}, TaskBar::WhenClosed::Stop, TaskBar::StartedBy::Program);
  EXPECT_EQ(waits, (std::vector{true, false}));
}

TEST(TaskBar, AJobMayStartTheNext) {
  TaskBar bar;
  bool second = false;
  bar.run<int>(
      "First", [](const Progress&) -> Result<int> { return 1; },
      [&](Result<int>) {
        bar.run<int>(
            "Second", [](const Progress&) -> Result<int> { return 2; }, [&](Result<int>) { second = true; });
      });
  EXPECT_TRUE(waitUntil([&] { return second; }));
}

TEST(TaskBar, ExceptionsBecomeErrors) {
  TaskBar bar;
  std::string message;
  bar.run<int>(
      "Failing", [](const Progress&) -> Result<int> { throw std::runtime_error("The disk is full."); },
      [&](Result<int> result) { message = result ? "no error" : result.error().message; });
  ASSERT_TRUE(waitUntil([&] { return !message.empty(); }));
  EXPECT_EQ(message, "The disk is full.");
}

TEST(TaskBar, GoesWhileItsJobIsAtWork) {
  bool called = false;
  {
    TaskBar bar;
    bar.run<int>("Turning", endless, [&](Result<int>) { called = true; });
  }
  EXPECT_TRUE(ui::waitForJobs(1000ms));
  QTest::qWait(60);
  EXPECT_FALSE(called);
}

}  // namespace
