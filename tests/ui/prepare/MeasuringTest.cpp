#include "model/CaseMeasuring.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <ui/support/Patience.h>

#include <QtTest/QTest>
#include <algorithm>
#include <thread>
#include <utility>

namespace insonate::prepare {
namespace {

using MeasuringState = CaseMeasuring::State;
using test::kPatience_ms;

std::shared_ptr<const PatientCase> patient() {
  return std::make_shared<const PatientCase>(test::smallCase());
}

/// Runs until it is told to stop.
void occupy(ui::TaskBar& tasks) {
  tasks.run<bool>(
      "something else",
      [](const Progress& progress) -> Result<bool> {
        while (progress("waiting", 0)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return true;
      },
      [](const Result<bool>&) {});
}

struct Bench {
  ui::TaskBar tasks;
  CaseMeasuring measuring{tasks, nullptr};
  bool reaches(MeasuringState state) {
    return QTest::qWaitFor([&] { return measuring.state() == state; }, kPatience_ms);
  }
};

TEST(Measuring, CountsAndChecks) {
  Bench b;
  b.measuring.setAllowed(true);
  EXPECT_EQ(b.measuring.state(), MeasuringState::Idle);
  const auto block = patient();
  b.measuring.setCase(block);
  ASSERT_TRUE(b.reaches(MeasuringState::Done));
  EXPECT_EQ(b.measuring.measures()->statistics.voxels[kVein],
            std::size_t(std::ranges::count(block->labels.voxels, kVein)));
  EXPECT_EQ(b.measuring.measures()->findings.size(), checkCase(*block)->size());
  b.measuring.setCase(nullptr);
  EXPECT_EQ(b.measuring.state(), MeasuringState::Idle);
  EXPECT_FALSE(b.measuring.measures());
}

TEST(Measuring, WaitsUntilItIsAllowed) {
  Bench b;
  b.measuring.setCase(patient());
  QTest::qWait(50);
  EXPECT_EQ(b.measuring.state(), MeasuringState::Waiting);
  b.measuring.setAllowed(true);
  EXPECT_TRUE(b.reaches(MeasuringState::Done));
}

TEST(Measuring, TakesItsTurnAfterOtherWork) {
  Bench b;
  b.measuring.setAllowed(true);
  occupy(b.tasks);
  b.measuring.setCase(patient());
  QTest::qWait(50);
  EXPECT_EQ(b.measuring.state(), MeasuringState::Waiting) << "what runs is not interrupted";
  b.tasks.cancel();
  EXPECT_TRUE(b.reaches(MeasuringState::Done));
}

TEST(Measuring, BeginsAgainAfterWorkThatTookItsPlace) {
  Bench b;
  b.measuring.setAllowed(true);
  b.measuring.setCase(patient());
  ASSERT_TRUE(b.reaches(MeasuringState::Running));
  occupy(b.tasks);
  QTest::qWait(50);
  EXPECT_EQ(b.measuring.state(), MeasuringState::Waiting);
  b.tasks.cancel();
  EXPECT_TRUE(b.reaches(MeasuringState::Done));
}

TEST(Measuring, TheUsersCancelEndsItUntilAsked) {
  Bench b;
  b.measuring.setAllowed(true);
  b.measuring.setCase(patient());
  ASSERT_TRUE(b.reaches(MeasuringState::Running));
  b.tasks.cancel();
  ASSERT_TRUE(b.reaches(MeasuringState::Stopped));
  EXPECT_FALSE(b.measuring.error().isEmpty());
  QTest::qWait(50);
  EXPECT_EQ(b.measuring.state(), MeasuringState::Stopped);
  b.measuring.start();
  EXPECT_TRUE(b.reaches(MeasuringState::Done));
}

TEST(Measuring, LetsGoOfLabelsThatAreEdited) {
  Bench b;
  b.measuring.setAllowed(true);
  const auto block = patient();
  b.measuring.setCase(block);
  auto labels = std::make_shared<const LabelMap>(block->labels);
  b.measuring.setLabels(labels);
  ASSERT_TRUE(b.reaches(MeasuringState::Running));
  const std::weak_ptr<const LabelMap> held = std::exchange(labels, nullptr);
  b.measuring.awaitLabels({});
  EXPECT_TRUE(QTest::qWaitFor([&] { return held.expired(); }, kPatience_ms));
  QTest::qWait(50);
  EXPECT_EQ(b.measuring.state(), MeasuringState::Waiting);
  b.measuring.setLabels(std::make_shared<const LabelMap>(block->labels));
  EXPECT_TRUE(b.reaches(MeasuringState::Done));
}

TEST(Measuring, GoesWhileItRuns) {
  ui::TaskBar tasks;
  auto measuring = std::make_unique<CaseMeasuring>(tasks, nullptr);
  measuring->setAllowed(true);
  measuring->setCase(patient());
  ASSERT_TRUE(QTest::qWaitFor([&] { return measuring->state() == MeasuringState::Running; }, kPatience_ms));
  measuring.reset();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !tasks.isRunning(); }, kPatience_ms));
}

}  // namespace
}  // namespace insonate::prepare
