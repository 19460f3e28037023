#include "WebmReader.h"
#include "support/FullDisk.h"
#include "support/TestData.h"

#include <insonate/video/ClipVideo.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using test::WebmReader;
using testing::HasSubstr;

/// Even gray frames, frame n of the clip with the gray value 40 * (n + 1).
class ClipVideoTest : public testing::Test {
 protected:
  Result<void> write(const ClipVideo& clip, const Progress& progress = {}) {
    drawn.clear();
    const auto draw = [&](std::size_t index, VideoFrame& frame) -> Result<void> {
      drawn.push_back(index);
      frame = {.width = clip.width, .height = clip.height, .channels = 1, .pixels = {}};
      frame.pixels.assign(std::size_t(clip.width) * clip.height, grayOf(index));
      return {};
    };
    return writeClipVideo(clip, file, draw, progress);
  }
  static std::uint8_t grayOf(std::size_t index) { return std::uint8_t(40 * (index + 1)); }

  test::TemporaryFolder folder;
  std::filesystem::path file = folder / "clip.webm";
  std::vector<std::size_t> drawn{};
};

TEST_F(ClipVideoTest, EachImageIsShownUntilTheNextOne) {
  ASSERT_TRUE(write({.width = 131, .height = 97, .time_s = {7, 7.101, 7.105, 7.5, 7.73}}));
  const WebmReader read(file);
  EXPECT_EQ(read.width, 132) << "odd sizes get one black column and row";
  EXPECT_EQ(read.height, 98);
  ASSERT_EQ(read.frames.size(), 23U) << "0.73 s are 21.9 intervals";
  EXPECT_NEAR(read.duration_ms, 23 * 1000.0 / 30, 1);
  for (const auto& [frame, index] :
       {std::pair<std::size_t, std::size_t>{0, 0}, {3, 0}, {4, 2}, {14, 2}, {15, 3}, {21, 3}, {22, 4}}) {
    EXPECT_NEAR(read.frames[frame].luma[20 * 132 + 20], grayOf(index), 3) << frame;
    EXPECT_LT(read.frames[frame].luma[97 * 132 + 20], 20) << frame;
  }
  EXPECT_THAT(drawn, testing::ElementsAre(0, 2, 3, 4)) << "image 1 was shown for 4 ms";
}

TEST_F(ClipVideoTest, OneImageIsAVideo) {
  ASSERT_TRUE(write({.width = 5, .height = 1, .time_s = {3}}));
  const WebmReader read(file);
  EXPECT_EQ(read.width, 16);
  EXPECT_EQ(read.height, 16);
  ASSERT_EQ(read.frames.size(), 1U);
  EXPECT_EQ(read.duration_ms, 33);
}

TEST_F(ClipVideoTest, SmallerFramesAreOnBlack) {
  const auto draw = [](std::size_t index, VideoFrame& frame) -> Result<void> {
    const int side = index == 0 ? 64 : 32;
    frame = {.width = side, .height = side, .channels = 1, .pixels = {}};
    frame.pixels.assign(std::size_t(side) * side, 200);
    return {};
  };
  ASSERT_TRUE(writeClipVideo({.width = 64, .height = 64, .time_s = {0, 0.5}}, file, draw));
  const WebmReader read(file);
  ASSERT_EQ(read.frames.size(), 16U);
  EXPECT_NEAR(read.frames[14].luma[50 * 64 + 50], 200, 5);
  EXPECT_LT(read.frames[15].luma[50 * 64 + 50], 20);
  EXPECT_NEAR(read.frames[15].luma[16 * 64 + 16], 200, 5);
  const auto larger = writeClipVideo({.width = 48, .height = 48, .time_s = {0}}, file, draw);
  ASSERT_FALSE(larger);
  EXPECT_THAT(larger.error().message, HasSubstr("64 x 64 pixels is larger than its clip"));
}

TEST_F(ClipVideoTest, NothingIsLeftAfterAFailure) {
  std::ofstream(file) << "before";
  const ClipVideo clip{.width = 640, .height = 480, .time_s = {0, 0.5, 1}};
  const auto cancel = [](std::string_view, double fraction) { return fraction < 0.5; };
  EXPECT_EQ(write(clip, cancel).error().message, kCancelled);
  EXPECT_THAT(write({.width = 64, .height = 64}).error().message, HasSubstr("no images"));
  EXPECT_THAT(write({.width = 5000, .height = 64, .time_s = {0}}).error().message, HasSubstr("16 to 4096"));
  {
    const test::FullDisk full(100);
    EXPECT_THAT(write(clip).error().message, HasSubstr("disk is full"));
  }
  EXPECT_EQ(test::bytesOf(file), "before");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  file = folder / "none" / "clip.webm";
  EXPECT_THAT(write(clip).error().message, HasSubstr("does not exist"));
}

}  // namespace
}  // namespace insonate
