#include "WebmReader.h"
#include "support/TestData.h"

#include <insonate/video/VideoWriter.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numeric>

namespace insonate {
namespace {

using test::WebmReader;
using testing::HasSubstr;

constexpr int kWidth = 128, kHeight = 96;

/// Gray value of a moving pattern, smooth like tissue with a little grain.
std::uint8_t grayAt(std::int64_t index, int x, int y) {
  const double grain = std::fmod(std::abs(std::sin(x * 12.9898 + y * 78.233)) * 43758.5453, 1.0);
  return std::uint8_t(128 + 80 * std::sin(0.1 * x + 0.2 * double(index)) * std::cos(0.07 * y) + 20 * grain);
}

Result<void> drawGray(std::int64_t index, VideoFrame& frame) {
  frame.width = kWidth, frame.height = kHeight, frame.channels = 1;
  frame.pixels.resize(std::size_t(kWidth) * kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) frame.pixels[std::size_t(y) * kWidth + x] = grayAt(index, x, y);
  return {};
}

class VideoWriterTest : public testing::Test {
 protected:
  test::TemporaryFolder folder;
  std::filesystem::path file = folder / "clip.webm";
};

TEST_F(VideoWriterTest, AnotherProgramReadsTheFramesTimesAndPixels) {
  ASSERT_TRUE(writeVideo(file, {.framesPerSecond = 15}, 100, &drawGray));
  const WebmReader read(file);
  EXPECT_EQ(read.docType, "webm");
  EXPECT_EQ(read.codec, "V_VP9");
  EXPECT_EQ(read.width, kWidth);
  EXPECT_EQ(read.height, kHeight);
  EXPECT_EQ(read.duration_ms, 6667);
  ASSERT_EQ(read.frames.size(), 100U);
  double squares = 0;
  for (std::size_t i = 0; i < read.frames.size(); ++i) {
    EXPECT_EQ(read.frames[i].time_ms, std::llround(double(i) * 1000 / 15));
    ASSERT_EQ(read.frames[i].luma.size(), std::size_t(kWidth) * kHeight) << i;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        squares += std::pow(read.frames[i].luma[std::size_t(y) * kWidth + x] - grayAt(std::int64_t(i), x, y), 2);
  }
  const double psnr_dB = 10 * std::log10(255 * 255 / (squares / (100.0 * kWidth * kHeight)));
  EXPECT_GT(psnr_dB, 34);
}

TEST_F(VideoWriterTest, APlayerCanJumpToEachPartOfTwoSeconds) {
  ASSERT_TRUE(writeVideo(file, {.framesPerSecond = 10}, 95, &drawGray));
  const WebmReader read(file);
  std::int64_t last_ms = 0;
  for (const auto& frame : read.frames) {
    if (!frame.isKey) continue;
    EXPECT_LE(frame.time_ms - last_ms, 2000);
    last_ms = frame.time_ms;
    ASSERT_TRUE(read.cues.contains(frame.time_ms)) << frame.time_ms;
    const auto cluster = read.clusters.find(read.cues.at(frame.time_ms));
    ASSERT_NE(cluster, read.clusters.end()) << "no cluster begins there";
    EXPECT_EQ(cluster->second, frame.time_ms);
  }
  EXPECT_GE(last_ms, 7500);
  EXPECT_EQ(read.seeks.at(std::uint64_t(webm::Id::kCues)), read.cuesAt);
  EXPECT_GT(read.cuesAt, 0U);
}

TEST_F(VideoWriterTest, ColorsKeepTheirBrightness) {
  const auto draw = [](std::int64_t, VideoFrame& frame) -> Result<void> {
    frame.width = frame.height = 32, frame.channels = 3;
    frame.pixels.clear();
    for (int i = 0; i < 32 * 32; ++i) frame.pixels.insert(frame.pixels.end(), {200, 40, 90});
    return {};
  };
  ASSERT_TRUE(writeVideo(file, {}, 3, draw));
  const WebmReader read(file);
  ASSERT_EQ(read.frames.size(), 3U);
  EXPECT_NEAR(read.frames[2].luma[500], 0.2126 * 200 + 0.7152 * 40 + 0.0722 * 90, 2);
}

TEST_F(VideoWriterTest, EqualFramesGiveEqualFiles) {
  ASSERT_TRUE(writeVideo(file, {}, 20, &drawGray));
  ASSERT_TRUE(writeVideo(folder / "again.webm", {}, 20, &drawGray));
  const auto bytes = [](const std::filesystem::path& of) {
    std::ifstream in(of, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  EXPECT_EQ(bytes(file), bytes(folder / "again.webm"));
}

TEST_F(VideoWriterTest, NothingIsLeftAfterAFailure) {
  std::ofstream(file) << "before";
  const auto cancel = [](std::string_view, double fraction) { return fraction < 0.5; };
  const auto cancelled = writeVideo(file, {}, 40, &drawGray, cancel);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
  const auto grows = [](std::int64_t index, VideoFrame& frame) {
    auto drawn = drawGray(index, frame);
    if (index == 3) frame.height /= 2, frame.pixels.resize(frame.pixels.size() / 2);
    return drawn;
  };
  const auto grown = writeVideo(file, {}, 10, grows);
  ASSERT_FALSE(grown);
  EXPECT_THAT(grown.error().message, HasSubstr("another size"));
  const auto odd = [](std::int64_t, VideoFrame& frame) -> Result<void> {
    frame = {.width = 33, .height = 32, .channels = 1, .pixels = std::vector<std::uint8_t>(33 * 32)};
    return {};
  };
  EXPECT_THAT(writeVideo(file, {}, 1, odd).error().message, HasSubstr("must be even"));
  EXPECT_THAT(writeVideo(file, {}, 0, &drawGray).error().message, HasSubstr("no frames"));
  EXPECT_THAT(writeVideo(file, {.framesPerSecond = 61}, 1, &drawGray).error().message, HasSubstr("1 to 60"));
  std::string text;
  std::getline(std::ifstream(file), text);
  EXPECT_EQ(text, "before");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / ""), {}), 1);
  EXPECT_FALSE(writeVideo(folder / "missing" / "clip.webm", {}, 1, &drawGray));
}

}  // namespace
}  // namespace insonate
