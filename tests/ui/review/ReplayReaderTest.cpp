#include "attempt/ReplayReader.h"

#include <insonate/procedure/AttemptRecorder.h>

#include <gtest/gtest.h>
#include <support/TestData.h>

#include <chrono>
#include <cmath>
#include <random>
#include <thread>

namespace insonate::review {
namespace {

constexpr std::int64_t kStep_us = 5000, kLength_us = 600'000'000;

/// Ten minutes at 200 samples a second; the probe's depth tells the time.
std::shared_ptr<const AttemptRecording> tenMinutes(const std::filesystem::path& file) {
  auto recorder = AttemptRecorder::start(file, {});
  for (std::int64_t time_us = kStep_us; time_us <= kLength_us; time_us += kStep_us) {
    AttemptSample sample;
    sample.time_us = time_us;
    sample.patientFromProbe = Transform{{}, {0, 0, double(time_us) * 1e-6}};
    while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    (*recorder)->record(sample);
  }
  EXPECT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  return std::make_shared<const AttemptRecording>(std::move(*AttemptRecording::open(file)));
}

/// Moving to any time unpacks one stretch, not the stretches before it.
TEST(ReplayReader, AnyTimeOfTenMinutesCostsOneStretch) {
  const test::TemporaryFolder folder;
  const auto recording = tenMinutes(folder / "ten");
  ReplayReader reader(recording);
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    const std::int64_t time_us = std::uniform_int_distribution<std::int64_t>(0, kLength_us)(random);
    const int before = reader.unpacked();
    const auto sample = reader.at(time_us);
    ASSERT_TRUE(sample);
    EXPECT_LE(reader.unpacked() - before, 1 + (time_us < kStep_us));
    const std::int64_t expected_us = std::max(kStep_us, time_us / kStep_us * kStep_us);
    EXPECT_EQ(sample->time_us, expected_us);
    EXPECT_NEAR(sample->patientFromProbe->offset.z, double(expected_us) * 1e-6, 2e-3);
  }
  // Playing on unpacks each stretch once.
  const int before = reader.unpacked();
  for (std::int64_t time_us = 100'000'000; time_us < 110'000'000; time_us += 33'000) ASSERT_TRUE(reader.at(time_us));
  EXPECT_LE(reader.unpacked() - before, 13);
  EXPECT_EQ(reader.at(0)->time_us, kStep_us) << "before the first sample, the first";
  EXPECT_EQ(reader.at(2 * kLength_us)->time_us, kLength_us);
}

/// The recorder closes a stretch after a second, whatever is in it.
TEST(ReplayReader, BeforeTheFirstSampleTheFirstAlsoBehindEvents) {
  const test::TemporaryFolder folder;
  auto recorder = AttemptRecorder::start(folder / "late", {});
  (*recorder)->record(AttemptEvent{.kind = AttemptEventKind::Positioned});
  std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  (*recorder)->record(AttemptSample{.time_us = 1000});
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const auto recording = std::make_shared<const AttemptRecording>(std::move(*AttemptRecording::open(folder / "late")));
  ASSERT_EQ(recording->segmentCount(), 2u);
  const auto sample = ReplayReader(recording).at(0);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->time_us, 1000);
}

TEST(ReplayReader, OfNothingThereIsNothing) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE((*AttemptRecorder::start(folder / "empty", {}))->finish(AttemptStatus::Completed));
  ReplayReader reader(std::make_shared<const AttemptRecording>(std::move(*AttemptRecording::open(folder / "empty"))));
  EXPECT_FALSE(reader.at(0));
}

}  // namespace
}  // namespace insonate::review
