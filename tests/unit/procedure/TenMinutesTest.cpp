#include "support/TestData.h"
#include "unit/procedure/HandMotion.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace insonate {
namespace {

double secondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Ten minutes of two noisy hands: what they take on the disk, and what it takes to be anywhere in them. The times are
/// properties in the report, not conditions.
TEST(TenMinutes, AreSmallAndQuickToReplay) {
  const test::TemporaryFolder folder;
  auto recorder = AttemptRecorder::start(folder / "attempt", {.picture = test::ScriptedAttempt::picture()});
  ASSERT_TRUE(recorder) << recorder.error().message;
  const auto samples = test::handMotion(600'000);
  (*recorder)->record(AttemptEvent{.kind = AttemptEventKind::Entered});
  for (const AttemptSample& sample : samples) {
    while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    (*recorder)->record(sample);
  }
  const auto live = (*recorder)->finish(AttemptStatus::Completed);
  ASSERT_TRUE(live) << live.error().message;
  const double megabytes = static_cast<double>(std::filesystem::file_size(folder / "attempt")) * 1e-6;
  RecordProperty("MB", std::to_string(megabytes));
  EXPECT_LT(megabytes, 20);

  auto begin = std::chrono::steady_clock::now();
  const auto recording = AttemptRecording::open(folder / "attempt");
  ASSERT_TRUE(recording) << recording.error().message;
  RecordProperty("open_s", std::to_string(secondsSince(begin)));
  begin = std::chrono::steady_clock::now();
  const RecordingSegment there = *recording->segment(recording->segmentAt(432'100'000));
  RecordProperty("seek_s", std::to_string(secondsSince(begin)));
  EXPECT_LE(there.samples.front().time_us, 432'100'000);
  EXPECT_GE(there.samples.back().time_us, 432'099'000);
  begin = std::chrono::steady_clock::now();
  EXPECT_EQ(*recording->metricsUntil(), *live);
  RecordProperty("metrics_s", std::to_string(secondsSince(begin)));
}

}  // namespace
}  // namespace insonate
