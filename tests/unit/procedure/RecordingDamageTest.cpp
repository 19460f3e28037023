#include "record/Block.h"
#include "record/SegmentCodec.h"
#include "support/TestData.h"
#include "unit/procedure/HandMotion.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

namespace insonate {
namespace {

using testing::HasSubstr;

/// A recording of 6 s of noisy hands, about 90 kB, set otherwise from 3 s on, and what is left of it.
class DamagedRecording : public testing::Test {
 protected:
  void SetUp() override {
    auto recorder = AttemptRecorder::start(
        folder / "whole", {.software = "insonate", .picture = {.sliceHalf_mm = 1}, .settings = "as it began"});
    for (const AttemptSample& sample : test::handMotion(6000)) {
      while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      (*recorder)->record(sample);
    }
    (*recorder)->recordFromOtherThread(SettingsChange{3'000'000, "changed"});
    const auto finished = (*recorder)->finish(AttemptStatus::Completed);
    ASSERT_TRUE(finished) << finished.error().message;
    metrics = *finished;
    bytes = test::bytesOf(folder / "whole");
  }
  Result<AttemptRecording> with(std::string_view changed) {
    std::ofstream(folder / "damaged", std::ios::binary | std::ios::trunc) << changed;
    return AttemptRecording::open(folder / "damaged");
  }

  /// Position and length of the block.
  std::pair<std::size_t, std::size_t> changeOfSettings() const {
    const std::string change = "changed";
    const auto* text = reinterpret_cast<const std::uint8_t*>(change.data());
    const record::Bytes block =
        record::packed(record::BlockKind::Settings, 3'000'000, 3'000'000, {text, change.size()});
    return {bytes.find(std::string(block.begin(), block.end())), block.size()};
  }

  const test::TemporaryFolder folder;
  std::string bytes;
  MetricValues metrics;
};

TEST_F(DamagedRecording, CutAnywhereItReadsToTheLastWholeStretch) {
  std::size_t last = 0;
  for (std::size_t length = 400; length < bytes.size(); length += 997) {
    const auto recording = with(std::string_view(bytes).substr(0, length));
    ASSERT_TRUE(recording) << length << ": " << recording.error().message;
    EXPECT_EQ(recording->status(), AttemptStatus::CutShort);
    ASSERT_GE(recording->segmentCount(), last);
    last = recording->segmentCount();
    ASSERT_TRUE(recording->metricsUntil()) << length;
    if (last > 0) {
      EXPECT_EQ(recording->segment(last - 1)->samples.back().time_us, recording->end_us());
    }
  }
  EXPECT_GE(last, 5u);
}

/// Whatever byte is wrong: the metrics are the right ones, or there are none and it says so.
TEST_F(DamagedRecording, AWrongByteIsNeverAWrongMetric) {
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    std::string changed = bytes;
    const std::size_t at = random() % bytes.size();
    changed[at] = static_cast<char>(changed[at] ^ (1 << random() % 8));
    const auto recording = with(changed);
    if (!recording) continue;  // the header's
    const auto values = recording->metricsUntil();
    EXPECT_TRUE(!values || *values == metrics) << "byte " << at;
  }
}

TEST_F(DamagedRecording, AWrongBitInAHeadIsNeverAWrongMetric) {
  const std::string mark(record::kMark.begin(), record::kMark.end());
  const std::int64_t end_us = AttemptRecording::open(folder / "whole")->end_us();
  for (std::size_t head = bytes.find(mark); head != std::string::npos; head = bytes.find(mark, head + 1)) {
    for (std::size_t bit = 0; bit < record::BlockHead::kBytes * 8; bit += 7) {
      std::string changed = bytes;
      changed[head + bit / 8] = static_cast<char>(changed[head + bit / 8] ^ (1 << bit % 8));
      const auto recording = with(changed);
      if (!recording) continue;  // the header's
      const auto values = recording->metricsUntil();
      EXPECT_TRUE(!values || (*values == metrics && recording->end_us() == end_us)) << head << ", bit " << bit;
    }
  }
}

/// Whatever byte is wrong: settings are the right ones, or there are none and it says so.
TEST_F(DamagedRecording, AWrongByteIsNeverAWrongSetting) {
  ASSERT_EQ(with(bytes)->settingsAt(3'000'000), "changed");
  const auto [at, size] = changeOfSettings();
  int refused = 0;
  for (std::size_t wrong = at; wrong < at + size; ++wrong) {
    std::string changed = bytes;
    changed[wrong] ^= 0x10;
    const auto recording = with(changed);
    ASSERT_TRUE(recording) << wrong;
    EXPECT_TRUE(recording->settingsAt(2'999'999).value_or("as it began") == "as it began") << wrong;
    const auto after = recording->settingsAt(3'000'000);
    EXPECT_TRUE(!after || *after == "changed") << wrong;
    EXPECT_TRUE(after || !recording->errors().empty()) << wrong;
    refused += !after;
  }
  EXPECT_EQ(refused, static_cast<int>(size)) << "each byte counts";
}

/// A damaged change leaves metrics, and images from before it.
TEST_F(DamagedRecording, ABadChangeOfSettingsIsSaid) {
  std::string broken = bytes;
  const auto [at, size] = changeOfSettings();
  broken[at + size - 1] ^= 1;
  const auto recording = with(broken);
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->metricsUntil(), metrics);
  EXPECT_EQ(recording->settingsAt(2'999'999), "as it began");
  EXPECT_THAT(recording->settingsAt(3'000'000).error().message, HasSubstr("the settings at 3.0 s are not known"));
  ASSERT_EQ(recording->errors().size(), 1u);
  EXPECT_THAT(recording->errors()[0], HasSubstr("the settings from 3.0 s on are unknown"));
  broken.erase(at, size);  // and one that is gone
  EXPECT_FALSE(with(broken)->settingsAt(3'000'000));
  EXPECT_EQ(with(broken)->metricsUntil(), metrics);
}

/// Written before recordings kept settings and tenting.
TEST_F(DamagedRecording, TheFirstFormatIsStillRead) {
  RecordingSegment segment;
  for (const AttemptSample& sample : test::handMotion(50)) segment.samples.push_back(quantize(sample));
  record::Bytes body = record::encoded(segment);
  body.resize(body.size() - 6 * (1 + 4 * segment.samples.size()));  // neither tenting nor instruments of the line
  const std::string header =
      R"({"format": 1, "software": "insonate 0.1.0", "begun": "", "procedure": "p", "procedureVersion": 1,
          "caseName": "c", "caseHash": "", "settingsHash": "", "engine": "none",
          "picture": {"width_mm": 38, "fanAngle_deg": 0, "faceRadius_mm": 0, "sliceHalf_mm": 1}})";
  const auto* text = reinterpret_cast<const std::uint8_t*>(header.data());
  record::Bytes old = record::packed(record::BlockKind::Header, 0, 0, {text, header.size()});
  for (const record::Bytes& more :
       {record::packed(record::BlockKind::RecordingSegment, 0, 49'000, body),
        record::packed(record::BlockKind::End, 49'000, 49'000, record::Bytes{0, 1, 0, 0, 0})})
    old.insert(old.end(), more.begin(), more.end());
  const auto recording = with({reinterpret_cast<const char*>(old.data()), old.size()});
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->status(), AttemptStatus::Completed);
  EXPECT_TRUE(recording->errors().empty());
  EXPECT_EQ(recording->settingsAt(1'000'000), "");
  EXPECT_EQ(recording->segment(0)->samples, segment.samples);
}

TEST_F(DamagedRecording, OneBadStretchLeavesTheOthers) {
  const auto whole = AttemptRecording::open(folder / "whole");
  std::string changed = bytes;
  changed[bytes.size() * 2 / 5] ^= 1;  // within what a stretch holds
  const auto recording = with(changed);
  ASSERT_TRUE(recording);
  std::size_t bad = 0;
  for (std::size_t i = 0; i < recording->segmentCount(); ++i) {
    const auto segment = recording->segment(i);
    if (segment) {
      EXPECT_EQ(segment->samples, whole->segment(i)->samples);
      continue;
    }
    ++bad;
    EXPECT_THAT(segment.error().message, HasSubstr("is damaged between"));
  }
  EXPECT_EQ(bad, 1u);
  EXPECT_FALSE(recording->metricsUntil());
}

/// A head that is gone takes its stretch along; the next one is found, and that one is missing is said.
TEST_F(DamagedRecording, ABadHeadIsSteppedOver) {
  std::string changed = bytes;
  const std::string mark(record::kMark.begin(), record::kMark.end());
  const std::size_t third = changed.find(mark, changed.find(mark, changed.find(mark) + 1) + 1);
  changed[third + 3] ^= 1;
  const auto recording = with(changed);
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->segmentCount() + 1, AttemptRecording::open(folder / "whole")->segmentCount());
  ASSERT_EQ(recording->errors().size(), 1u);
  EXPECT_THAT(recording->errors()[0], HasSubstr("parts of it cannot be found"));
  EXPECT_FALSE(recording->metricsUntil());
  const auto cutToo = with(changed.substr(0, changed.size() - 300));  // no end that would tell how many there were
  ASSERT_TRUE(cutToo);
  EXPECT_EQ(cutToo->errors().size(), 2u);
  EXPECT_FALSE(cutToo->metricsUntil());
}

/// Zeros compress to a thousandth.
TEST_F(DamagedRecording, SettingsThatWouldFillTheMemoryAreRefused) {
  using record::BlockKind;
  const auto settings = [](BlockKind kind, std::size_t size_bytes) {
    const record::Bytes block = record::packed(kind, 7'000'000, 7'000'000, record::Bytes(size_bytes));
    return std::string(block.begin(), block.end());
  };
  const std::string& whole = bytes;
  const std::string largest = settings(BlockKind::Settings, record::kMaxSettingsBytes);
  EXPECT_TRUE(with(whole + largest));
  for (const BlockKind kind : {BlockKind::Header, BlockKind::Settings})
    EXPECT_THAT(with(settings(kind, record::kMaxSettingsBytes + 1) + whole).error().message,
                HasSubstr("its settings are larger than those of any attempt"));
  std::string many = whole;
  for (std::uint32_t n = 0; n < record::kMaxBytesOfAllSettings / record::kMaxSettingsBytes; ++n) many += largest;
  EXPECT_LT(many.size(), 1U << 20);
  const auto refused = with(many);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("Look for an unchanged copy"));
}

TEST_F(DamagedRecording, OtherFilesAreRefusedWithASentence) {
  EXPECT_THAT(with("Dear colleague,").error().message, HasSubstr("is not a recording of an attempt"));
  EXPECT_THAT(with("").error().message, HasSubstr("is not a recording of an attempt"));
  EXPECT_THAT(AttemptRecording::open(folder / "nothing").error().message, HasSubstr("There is no recording"));
  EXPECT_THAT(AttemptRecording::open(folder.path()).error().message, HasSubstr("is not a file"));

  const std::string newer = R"({"format": 6, "software": "insonate 9"})";
  const auto block = record::packed(record::BlockKind::Header, 0, 0,
                                    {reinterpret_cast<const std::uint8_t*>(newer.data()), newer.size()});
  const auto refused = with({reinterpret_cast<const char*>(block.data()), block.size()});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("format 6 and this program reads up to 5"));
  EXPECT_THAT(refused.error().message, HasSubstr("insonate 9"));
}

}  // namespace
}  // namespace insonate
