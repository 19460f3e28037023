#include "record/Block.h"
#include "record/SegmentCodec.h"
#include "unit/procedure/HandMotion.h"

#include <gtest/gtest.h>

#include <limits>

namespace insonate::record {
namespace {

void expectSame(const RecordingSegment& segment) {
  const Bytes bytes = encoded(segment);
  const auto again = decoded(bytes);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->samples, segment.samples);
  EXPECT_EQ(again->samplesLost, segment.samplesLost);
  ASSERT_EQ(again->events.size(), segment.events.size());
  for (std::size_t i = 0; i < segment.events.size(); ++i) {
    EXPECT_EQ(again->events[i].afterSamples, segment.events[i].afterSamples);
    EXPECT_EQ(again->events[i].event, segment.events[i].event);
  }
}

RecordingSegment handsFor(int samples) {
  RecordingSegment segment;
  for (const AttemptSample& sample : test::handMotion(samples)) segment.samples.push_back(quantize(sample));
  return segment;
}

TEST(StretchCodec, GivesBackHandsToTheLastStep) {
  RecordingSegment segment = handsFor(1000);
  segment.samplesLost = 3;
  segment.events.push_back({0, {.time_us = 5, .kind = AttemptEventKind::Positioned, .tilt_deg = -15}});
  segment.events.push_back({1000,
                            {.time_us = 999'000,
                             .kind = AttemptEventKind::Left,
                             .wall = kVein,
                             .into = kMuscle,
                             .tip_mm = {0.1, -1e-9, 3e7},
                             .axis = normalized({1, 2, 3}),
                             .depth_mm = 31.7,
                             .outward = Vec3{0, 0.6, -0.8}}});
  segment.events.push_back({1000,
                            {.time_us = 999'000,
                             .kind = AttemptEventKind::Performed,
                             .act = LineAct::CheckLungSliding,
                             .instrument = Instrument::Catheter,
                             .amount = 3.5}});
  expectSame(segment);
}

/// A recording of format 4 has neither the instruments of the line nor their acts.
TEST(StretchCodec, ReadsSamplesAndEventsOfFormat4) {
  RecordingSegment segment = handsFor(20);
  segment.events.push_back({20, {.time_us = 5, .kind = AttemptEventKind::Entered, .wall = kVein, .vessel = 2}});
  Bytes bytes = encoded(segment);
  bytes.resize(bytes.size() - 10);  // act, instrument and amount of the event
  const std::size_t eventBytes = 4 + 8 + 3 + 24 + 24 + 8 + 1 + 24 + 8 + 1, channelBytes = 5 * (1 + 4 * 20);
  bytes.erase(bytes.end() - eventBytes - channelBytes, bytes.end() - eventBytes);
  const auto again = decoded(bytes);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->samples, segment.samples);
  ASSERT_EQ(again->events.size(), 1U);
  EXPECT_EQ(again->events[0].event, segment.events[0].event);
}

TEST(StretchCodec, GivesBackExtremes) {
  constexpr auto kLeast = std::numeric_limits<std::int32_t>::min(), kMost = std::numeric_limits<std::int32_t>::max();
  RecordingSegment segment;
  for (int i = 0; i < 7; ++i) {
    QuantizedSample sample;
    sample.time_us = 1'000'000'000'000 + i * 400'000'000LL;
    for (int c = 0; c < QuantizedSample::kChannels; ++c) sample.channel[c] = (i + c) % 3 ? kLeast + c : kMost - i;
    segment.samples.push_back(sample);
  }
  expectSame(segment);
}

TEST(StretchCodec, GivesBackNothing) {
  expectSame({});
}

/// A recording of ten minutes may take 20 MB: what a second may take, of noisy hands.
TEST(StretchCodec, TenMinutesOfTwoHandsAreBelow20MB) {
  std::size_t bytes = 0;
  const RecordingSegment all = handsFor(20'000);  // ten seconds outside, ten under the skin
  for (std::size_t begin = 0; begin < all.samples.size(); begin += 1000) {
    RecordingSegment second;
    second.samples.assign(all.samples.begin() + begin, all.samples.begin() + begin + 1000);
    bytes += packed(BlockKind::RecordingSegment, 0, 0, encoded(second)).size();
  }
  const double tenMinutes_MB = static_cast<double>(bytes) * 30 * 1e-6;
  RecordProperty("ten_minutes_MB", std::to_string(tenMinutes_MB));
  RecordProperty("bytes_a_sample", std::to_string(static_cast<double>(bytes) / 20'000));
  EXPECT_LT(tenMinutes_MB, 20);
}

TEST(StretchCodec, RefusesWhatIsNoStretch) {
  Bytes bytes = encoded(handsFor(10));
  EXPECT_TRUE(decoded(bytes));
  bytes.push_back(0);
  EXPECT_FALSE(decoded(bytes)) << "too long";
  bytes.pop_back(), bytes.pop_back();
  EXPECT_FALSE(decoded(bytes)) << "too short";
  EXPECT_FALSE(decoded({}));
  bytes = encoded(handsFor(10));
  bytes[0] = bytes[1] = bytes[2] = bytes[3] = 0xff;
  EXPECT_FALSE(decoded(bytes)) << "four milliards of samples";
  RecordingSegment odd;
  odd.events.push_back({0, {}});
  bytes = encoded(odd);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    Bytes wrong = bytes;
    wrong[i] = 0xee;
    decoded(wrong);  // whatever it says, it ends
  }
}

}  // namespace
}  // namespace insonate::record
