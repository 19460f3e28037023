#include "record/SampleRing.h"
#include "support/Allocations.h"
#include "support/TestData.h"
#include "unit/procedure/HandMotion.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace insonate {
namespace {

using testing::HasSubstr;

AttemptHeader header() {
  ImageField picture = test::ScriptedAttempt::picture();
  picture.elevationFocus_mm = 16, picture.elevationDivergence = 0.29, picture.elevationDivergenceBehind = 0.085;
  return {"insonate 0.1.0", "2026-01-02T03:04:05Z", "internal_jugular", 1, "neck", "c0ffee", "5e77", "cpu", picture};
}

template <class What>
void putWhenThereIsRoom(AttemptRecorder& recorder, const What& what) {
  while (recorder.freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  recorder.record(what);
}

/// A used needle, both walls of the vein, 9 s.
test::ScriptedAttempt eventful() {
  test::ScriptedAttempt attempt;
  attempt.needleTo(12), attempt.needleTo(-5), attempt.needleTo(35), attempt.needleTo(25);
  return attempt;
}

void put(AttemptRecorder& recorder, const test::ScriptedAttempt& attempt) {
  for (const auto& entry : attempt.stream)
    std::visit([&](const auto& what) { putWhenThereIsRoom(recorder, what); }, entry);
}

class RecorderTest : public testing::Test {
 protected:
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "attempt.insonate", part = AttemptRecorder::partialFile(file);
};

TEST_F(RecorderTest, ReplayGivesTheLiveMetricsAndEverySample) {
  const auto attempt = eventful();
  auto recorder = AttemptRecorder::start(file, header());
  ASSERT_TRUE(recorder) << recorder.error().message;
  put(**recorder, attempt);
  EXPECT_FALSE(std::filesystem::exists(file)) << "it has its name when it is whole";
  const auto live = (*recorder)->finish(AttemptStatus::Completed);
  ASSERT_TRUE(live) << live.error().message;
  EXPECT_EQ((*recorder)->metrics(), *live);
  EXPECT_EQ(live->values[static_cast<int>(Metric::PosteriorWallPunctures)], 1);
  EXPECT_FALSE(std::filesystem::exists(part));

  const auto recording = AttemptRecording::open(file);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->header(), header());
  EXPECT_EQ(recording->status(), AttemptStatus::Completed);
  EXPECT_TRUE(recording->errors().empty());
  EXPECT_EQ(*recording->metricsUntil(), *live);

  std::vector<QuantizedSample> samples;
  std::vector<AttemptEvent> events;
  for (std::size_t i = 0; i < recording->segmentCount(); ++i) {
    const RecordingSegment segment = *recording->segment(i);
    samples.insert(samples.end(), segment.samples.begin(), segment.samples.end());
    for (const auto& happened : segment.events) events.push_back(happened.event);
  }
  std::size_t sample = 0, event = 0;
  for (const auto& entry : attempt.stream) {
    if (const auto* s = std::get_if<AttemptSample>(&entry)) {
      ASSERT_EQ(samples.at(sample++), quantize(*s));
    } else {
      ASSERT_EQ(events.at(event++), std::get<AttemptEvent>(entry));
    }
  }
  EXPECT_EQ(sample, samples.size());
  EXPECT_EQ(event, events.size());
}

/// At any time, the metrics of what had happened by then.
TEST_F(RecorderTest, MetricsAsTheyStoodAtAnyTime) {
  const auto attempt = eventful();
  auto recorder = AttemptRecorder::start(file, header());
  put(**recorder, attempt);
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const auto recording = AttemptRecording::open(file);
  for (const std::int64_t until_us : {0LL, 1'700'000LL, 2'000'000LL, 5'999'000LL, 7'500'000LL, 99'000'000LL}) {
    AttemptMetrics truth(header().picture);
    for (const auto& entry : attempt.stream) {
      const bool later = std::visit([&](const auto& what) { return what.time_us > until_us; }, entry);
      if (later) break;
      if (const auto* sample = std::get_if<AttemptSample>(&entry)) {
        truth.add(dequantize(quantize(*sample)));
      } else {
        truth.add(std::get<AttemptEvent>(entry));
      }
    }
    EXPECT_EQ(*recording->metricsUntil(until_us), truth.values()) << until_us;
    if (recording->segmentCount() > 1 && until_us > 0 && until_us < 7'000'000) {
      const RecordingSegment there = *recording->segment(recording->segmentAt(until_us));
      EXPECT_LE(there.samples.front().time_us, until_us);
      EXPECT_GT(there.samples.back().time_us + 1001, until_us);
    }
  }
}

TEST_F(RecorderTest, WhatOthersTellIsKept) {
  auto recorder = AttemptRecorder::start(file, header());
  (*recorder)->record(AttemptSample{.time_us = 1000});
  std::thread([&] {
    (*recorder)->recordFromOtherThread({.time_us = 1500, .kind = AttemptEventKind::Positioned, .tilt_deg = 15});
  }).join();
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const RecordingSegment segment = *AttemptRecording::open(file)->segment(0);
  ASSERT_EQ(segment.events.size(), 1u);
  EXPECT_EQ(segment.events[0].event.tilt_deg, 15);
  EXPECT_EQ(segment.events[0].afterSamples, 1u);
}

TEST_F(RecorderTest, SettingsAreKnownAtAnyTime) {
  AttemptHeader begun = header();
  begun.settings = R"({"gain_dB": 0})";
  begun.hands = {"camera", "mouse"};
  auto recorder = AttemptRecorder::start(file, begun);
  ASSERT_TRUE(recorder) << recorder.error().message;
  put(**recorder, eventful());
  (*recorder)->recordFromOtherThread(SettingsChange{2'000'000, R"({"gain_dB": 3})"});
  (*recorder)->recordFromOtherThread(SettingsChange{2'500'000, R"({"gain_dB": 3})"});  // changes nothing
  (*recorder)->recordFromOtherThread(SettingsChange{7'000'000, R"({"gain_dB": 6})"});
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const auto recording = AttemptRecording::open(file);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_TRUE(recording->errors().empty());
  EXPECT_EQ(recording->header().settings, begun.settings);
  EXPECT_EQ(recording->header().hands, begun.hands);
  EXPECT_EQ(recording->header().settingsHash, "05832dc249f0c8d5") << "FNV-1a of the text";
  EXPECT_EQ(recording->settingsChanges().size(), 2u);
  EXPECT_EQ(recording->settingsAt(1'999'999), begun.settings);
  EXPECT_EQ(recording->settingsAt(2'000'000), R"({"gain_dB": 3})");
  EXPECT_EQ(recording->settingsAt(6'999'999), R"({"gain_dB": 3})");
  EXPECT_EQ(recording->settingsAt(60'000'000), R"({"gain_dB": 6})");
}

TEST_F(RecorderTest, TimeDoesNotGoBack) {
  auto recorder = AttemptRecorder::start(file, header());
  (*recorder)->recordFromOtherThread({.time_us = 9'000'000, .kind = AttemptEventKind::Frozen});
  for (const int time_us : {1000, 2000, 1500, 3000}) (*recorder)->record(AttemptSample{.time_us = time_us});
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const auto recording = AttemptRecording::open(file);
  std::size_t samples = 0;
  for (std::size_t i = 0; i < recording->segmentCount(); ++i) samples += recording->segment(i)->samples.size();
  EXPECT_EQ(samples, 3u) << "an event from another clock holds nothing up";
}

TEST_F(RecorderTest, EveryAttemptIsKeptWithItsStatus) {
  {
    auto recorder = AttemptRecorder::start(file, header());
    put(**recorder, eventful());
  }
  const auto recording = AttemptRecording::open(file);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->status(), AttemptStatus::Abandoned);
  EXPECT_EQ((*recording->metricsUntil())[Metric::UsedNeedleInsertions], 1);
}

TEST_F(RecorderTest, NothingIsWrittenOver) {
  std::ofstream(file) << "a letter";
  const auto there = AttemptRecorder::start(file, header());
  ASSERT_FALSE(there);
  EXPECT_THAT(there.error().message, HasSubstr("exists"));
  std::filesystem::rename(file, part);
  const auto earlier = AttemptRecorder::start(file, header());
  ASSERT_FALSE(earlier);
  EXPECT_THAT(earlier.error().message, HasSubstr("was not completed"));
  EXPECT_EQ(test::bytesOf(part), "a letter");
  const auto nowhere = AttemptRecorder::start(folder / "no/such/folder/a.insonate", header());
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr("No such file or directory"));
}

/// The servo's side by itself: no memory is asked for, and a reader that never comes costs what does not fit.
TEST(SampleRing, NeitherAllocatesNorWaits) {
  const auto ring = std::make_unique<record::SampleRing>();
  const auto samples = test::handMotion(5000);
  const long before = test::allocations();
  for (const AttemptSample& sample : samples) ring->put(sample);
  ring->put(AttemptEvent{.outward = Vec3{}});
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(ring->room(), 0u);
  EXPECT_EQ(ring->takeLost(), 5001 - 4096u);
  std::size_t at = 0;
  ring->drain([&](const record::RingEntry& entry) { EXPECT_EQ(std::get<AttemptSample>(entry), samples[at++]); });
  EXPECT_EQ(at, 4096u);
  EXPECT_EQ(ring->room(), 4096u);
}

TEST(SampleRing, KeepsOrderBetweenThreads) {
  const auto ring = std::make_unique<record::SampleRing>();
  constexpr int kCount = 200'000;
  std::thread writer([&] {
    for (int i = 0; i < kCount;)
      if (ring->room() > 0) ring->put(AttemptSample{.time_us = i++});
  });
  std::int64_t next = 0;
  while (next < kCount)
    ring->drain([&](const record::RingEntry& entry) { EXPECT_EQ(std::get<AttemptSample>(entry).time_us, next++); });
  writer.join();
  EXPECT_EQ(ring->takeLost(), 0u);
}

/// A disk that is full: the attempt goes on, and what was written stays readable.
TEST_F(RecorderTest, AFullDisk) {
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{40'000, old.rlim_max};
  auto recorder = AttemptRecorder::start(file, header());
  setrlimit(RLIMIT_FSIZE, &small);
  for (const AttemptSample& sample : test::handMotion(9000)) putWhenThereIsRoom(**recorder, sample);
  const auto finished = (*recorder)->finish(AttemptStatus::Completed);
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, ignored);
  ASSERT_FALSE(finished);
  EXPECT_THAT(finished.error().message, HasSubstr("can no longer be written"));
  EXPECT_THAT(finished.error().message, HasSubstr(part.string()));
  EXPECT_EQ((*recorder)->error(), finished.error().message);
  EXPECT_THAT((*recorder)->metrics()[Metric::AttemptTime], testing::Optional(testing::DoubleNear(9, 0.01)));
  const auto recording = AttemptRecording::open(part);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->status(), AttemptStatus::CutShort);
  EXPECT_GE(recording->segmentCount(), 1u);
  EXPECT_TRUE(recording->metricsUntil()) << recording->metricsUntil().error().message;
}

/// Killed after 5.5 s: what is left reaches to the last second.
TEST_F(RecorderTest, AKilledProgramLeavesAllButTheLastSecond) {
  const auto samples = test::handMotion(5500);
  const pid_t child = fork();
  if (child == 0) {
    auto recorder = AttemptRecorder::start(file, header());
    for (const AttemptSample& sample : samples) putWhenThereIsRoom(**recorder, sample);
    while ((*recorder)->metrics()[Metric::AttemptTime].value_or(0) < 5.49)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  const auto recording = AttemptRecording::open(part);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->status(), AttemptStatus::CutShort);
  EXPECT_GT(recording->end_us(), 4'500'000);
  ASSERT_EQ(recording->errors().size(), 1u);
  EXPECT_THAT(recording->errors()[0],
              HasSubstr("stopped early, so the attempt counts as abandoned; the recording can be read up to"));
  EXPECT_TRUE(recording->metricsUntil());
}

}  // namespace
}  // namespace insonate
