#include "HandScene.h"
#include "sources/PixelFormats.h"
#include "sources/VideoErrors.h"
#include "support/TestData.h"

#include <insonate/camera/CameraSource.h>
#include <insonate/camera/VideoDevice.h>

#include <gmock/gmock.h>
#include <jpeglib.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <random>

namespace insonate::test {
namespace {

using testing::HasSubstr;

constexpr std::chrono::milliseconds kNow{0};

CameraFrame gradient(int width, int height) {
  CameraFrame frame;
  frame.width = width, frame.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) frame.pixels.push_back(std::uint8_t(2 * x + y));
  return frame;
}

std::vector<std::uint8_t> jpegOf(const CameraFrame& frame) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = JDIMENSION(frame.width), jpeg.image_height = JDIMENSION(frame.height);
  jpeg.input_components = 1, jpeg.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 95, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  for (int y = 0; y < frame.height; ++y) {
    auto* row = const_cast<JSAMPLE*>(&frame.pixels[std::size_t(y) * std::size_t(frame.width)]);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::vector<std::uint8_t> result(bytes, bytes + size);
  std::free(bytes);
  return result;
}

TEST(CameraSource, ReadsAFolderOfFramesInTheOrderOfTheirNames) {
  const TemporaryFolder folder;
  CameraFrame first = gradient(40, 30), second = first;
  second.pixels[7] = 99;
  ASSERT_TRUE(writePgm(second, folder / "b.pgm"));
  ASSERT_TRUE(writePgm(first, folder / "a.pgm"));
  std::ofstream(folder / "notes.txt") << "no frame";
  const auto source = openRecordedFrames(folder.path());
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_EQ((*source)->width(), 40);
  CameraFrame frame;
  ASSERT_EQ((*source)->next(frame, kNow).value(), CameraStatus::kFrame);
  EXPECT_EQ(frame.pixels, first.pixels);
  const std::int64_t time_ns = frame.time_ns;
  ASSERT_EQ((*source)->next(frame, kNow).value(), CameraStatus::kFrame);
  EXPECT_EQ(frame.pixels, second.pixels);
  EXPECT_NEAR(double(frame.time_ns - time_ns), 1e9 / 30, 2);
  EXPECT_EQ((*source)->next(frame, kNow).value(), CameraStatus::kEnded);
}

TEST(CameraSource, ReadsRawFilesByTheirName) {
  const TemporaryFolder folder;
  const CameraFrame frame = gradient(32, 20);
  {
    std::ofstream gray(folder / "x_32x20.y8", std::ios::binary), color(folder / "x_32x20.yuyv", std::ios::binary);
    for (int i = 0; i < 2; ++i)
      for (const std::uint8_t value : frame.pixels) gray.put(char(value)), color.put(char(value)), color.put(char(128));
  }
  for (const char* name : {"x_32x20.y8", "x_32x20.yuyv"}) {
    const auto source = openRecordedFrames(folder / name);
    ASSERT_TRUE(source) << source.error().message;
    CameraFrame read;
    for (int i = 0; i < 2; ++i) {
      ASSERT_EQ((*source)->next(read, kNow).value(), CameraStatus::kFrame);
      EXPECT_EQ(read.pixels, frame.pixels) << name;
    }
    EXPECT_EQ((*source)->next(read, kNow).value(), CameraStatus::kEnded);
  }
}

TEST(CameraSource, ErrorsOfRecordingsSayWhatToDo) {
  const TemporaryFolder folder;
  const auto error = [](const std::filesystem::path& path) { return openRecordedFrames(path).error().message; };
  EXPECT_THAT(error(folder / "none"), HasSubstr("does not exist"));
  EXPECT_THAT(error(folder.path()), HasSubstr("no PGM or PNG"));
  std::ofstream(folder / "frames.raw") << "x";
  EXPECT_THAT(error(folder / "frames.raw"), HasSubstr("states no size"));
  std::ofstream(folder / "x_0x10.y8") << "x";
  EXPECT_THAT(error(folder / "x_0x10.y8"), HasSubstr("1 to 8192"));
  std::ofstream(folder / "x_10x10.y8") << "short";
  CameraFrame frame;
  EXPECT_THAT((*openRecordedFrames(folder / "x_10x10.y8"))->next(frame, kNow).error().message,
              HasSubstr("ends within"));
  std::filesystem::create_directory(folder / "damaged");
  std::ofstream(folder.path() / "damaged" / "a.png") << "no PNG";
  EXPECT_THAT(error(folder / "damaged"), HasSubstr("a.png"));
}

TEST(CameraSource, DamagedImagesAreRefused) {
  const TemporaryFolder folder;
  std::mt19937 random(9);
  const std::filesystem::path file = folder.path() / "a.pgm";
  ASSERT_TRUE(writePgm(gradient(20, 10), file));
  std::ifstream in(file, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    for (unsigned k = 0; k < 1 + random() % 3; ++k) damaged[random() % 14] = char(random());
    if (random() % 3 == 0) damaged.resize(random() % damaged.size());
    std::ofstream(file, std::ios::binary) << damaged;
    const auto source = openRecordedFrames(folder.path());
    CameraFrame frame;
    const bool isRead = source && (*source)->next(frame, kNow);
    EXPECT_TRUE(!isRead || frame.pixels.size() == std::size_t(frame.width) * std::size_t(frame.height));
  }
}

TEST(PixelFormats, JpegOfACameraIsDecodedAndDamageIsRefused) {
  const CameraFrame frame = gradient(64, 48);
  const auto bytes = jpegOf(frame);
  std::vector<std::uint8_t> gray;
  ASSERT_TRUE(camera::grayFromJpeg(bytes, 64, 48, gray));
  for (std::size_t i = 0; i < gray.size(); ++i) EXPECT_NEAR(gray[i], frame.pixels[i], 8);
  EXPECT_FALSE(camera::grayFromJpeg(bytes, 64, 50, gray));
  EXPECT_FALSE(camera::grayFromJpeg({}, 64, 48, gray));
  std::mt19937 random(10);
  for (int i = 0; i < 500; ++i) {
    auto damaged = bytes;
    for (unsigned k = 0; k < 1 + random() % 5; ++k) damaged[random() % damaged.size()] = std::uint8_t(random());
    if (random() % 2) damaged.resize(random() % damaged.size());
    camera::grayFromJpeg(damaged, 64, 48, gray);
    EXPECT_EQ(gray.size(), 64U * 48U);
  }
}

TEST(PixelFormats, ShortBuffersAreRefused) {
  std::vector<std::uint8_t> bytes(100), gray;
  EXPECT_FALSE(camera::grayFromYuyv(bytes, 10, 6, 20, gray));
  EXPECT_TRUE(camera::grayFromYuyv(bytes, 10, 5, 20, gray));
  EXPECT_FALSE(camera::grayFromGray(bytes, 10, 5, 8, gray));
  EXPECT_TRUE(camera::grayFromGray(bytes, 10, 5, 20, gray));
}

TEST(VideoDevice, ErrorsSayWhatToDo) {
  EXPECT_THAT(openVideoDevice("/dev/video-none").error().message, HasSubstr("there is no camera"));
  EXPECT_THAT(openVideoDevice("/dev/null").error().message, HasSubstr("is no camera"));
  EXPECT_THAT(camera::videoError("/dev/video0", EBUSY), HasSubstr("another program"));
  EXPECT_THAT(camera::videoError("/dev/video0", EACCES), HasSubstr("group 'video'"));
  EXPECT_THAT(camera::videoError("/dev/video0", ENODEV), HasSubstr("unplugged"));
  EXPECT_THAT(camera::videoError("/dev/video0", ENOSPC), HasSubstr("USB"));
  EXPECT_THAT(camera::videoError("/dev/video0", ENOMEM), HasSubstr("cannot be used"));
}

TEST(VideoDevice, CamerasThatAreThereSendFrames) {
  const auto devices = listVideoDevices();
  if (devices.empty()) GTEST_SKIP() << "No camera is plugged in.";
  const auto camera = openVideoDevice(devices.front().path);
  ASSERT_TRUE(camera) << camera.error().message;
  CameraFrame frame;
  CameraStatus status = CameraStatus::kWaiting;
  for (int i = 0; i < 50 && status != CameraStatus::kFrame; ++i) {
    const auto next = (*camera)->next(frame, std::chrono::milliseconds(100));
    ASSERT_TRUE(next) << next.error().message;
    status = *next;
  }
  ASSERT_EQ(status, CameraStatus::kFrame);
  EXPECT_EQ(frame.pixels.size(), std::size_t(frame.width) * std::size_t(frame.height));
}

}  // namespace
}  // namespace insonate::test
