#include "support/FullDisk.h"
#include "support/TestData.h"

#include <insonate/cases/DicomClip.h>
#include <insonate/core/Vec3.h>

#include <gdcmImageReader.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <sstream>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// Frames of odd size, each with an even gray and two bright pixels, 12.5 mm apart along both axes.
class DicomClipTest : public testing::Test {
 protected:
  static constexpr int kWidth = 331, kHeight = 277, kLeft = 40, kTop = 31;
  static constexpr double kPixel_mm = 0.0731, kApart_mm = 12.5, kFirstLateral_mm = -7.3, kFirstDepth_mm = 2.2;

  static DicomClip clipOf(std::vector<double> time_s, int channels = 1) {
    return {.identity = {.seed = "case/1", .patientName = "Insonate^Case", .patientId = "1", .description = "test"},
            .seed = "now",
            .width = kWidth,
            .height = kHeight,
            .channels = channels,
            .region = {kLeft, kTop, 280, 240, kPixel_mm, -9.7, -0.4},
            .time_s = std::move(time_s)};
  }

  static std::uint8_t grayOf(std::size_t index) { return std::uint8_t(10 + 20 * index); }

  static void setPixel(const DicomClip& clip, double lateral_mm, double depth_mm, std::vector<std::uint8_t>& pixels) {
    const auto column = std::lround((lateral_mm - clip.region.left_mm) / kPixel_mm) + kLeft;
    const auto row = std::lround((depth_mm - clip.region.top_mm) / kPixel_mm) + kTop;
    for (int channel = 0; channel < clip.channels; ++channel)
      pixels[(std::size_t(row) * kWidth + std::size_t(column)) * clip.channels + channel] = 255;
  }

  Result<void> write(const DicomClip& clip, const Progress& progress = {}) const {
    const auto draw = [&](std::size_t index, std::vector<std::uint8_t>& pixels) -> Result<void> {
      pixels.assign(std::size_t(kWidth) * kHeight * clip.channels, grayOf(index));
      if (clip.channels == 3) pixels[1] = 99;
      setPixel(clip, kFirstLateral_mm, kFirstDepth_mm, pixels);
      setPixel(clip, kFirstLateral_mm + kApart_mm, kFirstDepth_mm + kApart_mm, pixels);
      return {};
    };
    return writeDicomClip(clip, file, draw, progress);
  }

  struct Frames {
    unsigned width = 0, height = 0, count = 0;
    std::vector<char> bytes;
    std::uint8_t at(std::size_t place) const { return static_cast<std::uint8_t>(bytes.at(place)); }
  };
  Frames readByGdcm() const {
    gdcm::ImageReader reader;
    reader.SetFileName(file.c_str());
    EXPECT_TRUE(reader.Read()) << file;
    const gdcm::Image& image = reader.GetImage();
    Frames frames{image.GetDimension(0),
                  image.GetDimension(1),
                  image.GetNumberOfDimensions() == 3 ? image.GetDimension(2) : 1,
                  {}};
    frames.bytes.resize(image.GetBufferLength());
    EXPECT_TRUE(image.GetBuffer(frames.bytes.data()));
    return frames;
  }

  /// Values by the tag's text "0x0018,0x602c", as dcdump (dicom3tools) prints them, without brackets.
  std::map<std::string, std::string> readByDcdump() const {
    const fs::path report = folder / "dump";
    EXPECT_EQ(std::system(("dcdump '" + file.string() + "' >'" + report.string() + "' 2>&1").c_str()), 0);
    std::map<std::string, std::string> values;
    std::istringstream lines(test::bytesOf(report));
    const std::regex element(R"(\((0x\w{4},0x\w{4})\).*VL=<\w+>\s+[<\[{](.*?)\s*[>\]}]\s*)");
    std::smatch found;
    for (std::string line; std::getline(lines, line);)
      if (std::regex_match(line.erase(0, line.find_first_not_of(" >")), found, element)) values[found[1]] = found[2];
    return values;
  }
  static bool has(const char* program) {
    return std::system(("command -v " + std::string(program) + " >/dev/null").c_str()) == 0;
  }

  test::TemporaryFolder folder;
  fs::path file = folder / "clip.dcm";
};

TEST_F(DicomClipTest, AnotherProgramReadsTheFrames) {
  for (const int channels : {1, 3}) {
    ASSERT_TRUE(write(clipOf({0, 0.04, 0.08}, channels)));
    const Frames frames = readByGdcm();
    EXPECT_EQ(frames.width, unsigned(kWidth));
    EXPECT_EQ(frames.height, unsigned(kHeight));
    ASSERT_EQ(frames.count, 3U);
    const std::size_t size = std::size_t(kWidth) * kHeight * channels;
    ASSERT_EQ(frames.bytes.size(), 3 * size);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(frames.at(i * size), grayOf(i));
      EXPECT_EQ(frames.at(i * size + 1), channels == 3 ? 99 : grayOf(i));
      EXPECT_EQ(frames.at((i + 1) * size - 1), grayOf(i));
    }
  }
}

TEST_F(DicomClipTest, ADistanceIsMeasuredInMillimeters) {
  if (!has("dcdump")) GTEST_SKIP() << "dcdump (dicom3tools) is not installed";
  ASSERT_TRUE(write(clipOf({0, 0.04})));
  const Frames frames = readByGdcm();
  std::vector<Vec3> bright;
  for (std::size_t i = 0; i < std::size_t(kWidth) * kHeight; ++i)
    if (frames.at(i) == 255) bright.push_back({double(i % kWidth), double(i / kWidth), 0});
  ASSERT_EQ(bright.size(), 2U);
  auto values = readByDcdump();
  EXPECT_EQ(values["0x0018,0x6024"], "0x0003") << "cm";
  EXPECT_EQ(values["0x0018,0x6026"], "0x0003");
  EXPECT_EQ(values["0x0018,0x6012"], "0x0001") << "2D";
  EXPECT_EQ(values["0x0018,0x6014"], "0x0001") << "tissue";
  const double dx_mm = 10 * std::stod(values["0x0018,0x602c"]), dy_mm = 10 * std::stod(values["0x0018,0x602e"]);
  EXPECT_NEAR((bright[1].x - bright[0].x) * dx_mm, kApart_mm, kPixel_mm);
  EXPECT_NEAR((bright[1].y - bright[0].y) * dy_mm, kApart_mm, kPixel_mm);
  // The reference pixel gives the depth below the probe and the lateral position.
  const double x0 = std::stoi(values["0x0018,0x6018"], nullptr, 16),
               y0 = std::stoi(values["0x0018,0x601a"], nullptr, 16);
  EXPECT_NEAR(10 * std::stod(values["0x0018,0x6028"]) + (bright[0].x - x0) * dx_mm, kFirstLateral_mm, kPixel_mm);
  EXPECT_NEAR(10 * std::stod(values["0x0018,0x602a"]) + (bright[0].y - y0) * dy_mm, kFirstDepth_mm, kPixel_mm);
  EXPECT_EQ(std::stoi(values["0x0018,0x601c"], nullptr, 16), kLeft + 280 - 1);
  EXPECT_EQ(std::stoi(values["0x0018,0x601e"], nullptr, 16), kTop + 240 - 1);
}

TEST_F(DicomClipTest, StatesTimesAndThatItIsSimulated) {
  if (!has("dcdump")) GTEST_SKIP() << "dcdump (dicom3tools) is not installed";
  ASSERT_TRUE(write(clipOf({1, 1.05, 1.1, 1.15})));
  auto values = readByDcdump();
  EXPECT_EQ(values["0x0008,0x0016"], "1.2.840.10008.5.1.4.1.1.3.1");
  EXPECT_EQ(values["0x0028,0x0008"], "4");
  EXPECT_NEAR(std::stod(values["0x0018,0x1063"]), 50, 1e-6);
  EXPECT_EQ(values["0x0028,0x0009"], "(0x0018,0x1063)");
  EXPECT_EQ(values["0x0018,0x0040"], "20");
  EXPECT_EQ(values["0x0008,0x0008"], "DERIVED\\SECONDARY");
  EXPECT_THAT(values["0x0008,0x103e"], "SIMULATED ultrasound, test");
  EXPECT_THAT(values["0x0008,0x2111"], HasSubstr("not acquired from a patient"));
  EXPECT_EQ(values["0x0008,0x001c"], "YES");
  EXPECT_EQ(values["0x0028,0x0301"], "NO");
  const std::string instance = values["0x0008,0x0018"], study = values["0x0020,0x000d"];
  ASSERT_TRUE(write(clipOf({1, 1.05, 1.1, 1.25})));
  values = readByDcdump();
  EXPECT_EQ(values["0x0018,0x1065"], "0\\50\\50\\150");
  EXPECT_EQ(values["0x0028,0x0009"], "(0x0018,0x1065)");
  EXPECT_EQ(values.count("0x0018,0x1063"), 0U);
  DicomClip later = clipOf({0});
  later.seed = "later";
  later.identity.description = "a\\b " + std::string(37, 'x') + "\u00fc and more";
  ASSERT_TRUE(write(later));
  values = readByDcdump();
  EXPECT_EQ(values["0x0028,0x0008"], "1") << "one image is a clip, too";
  EXPECT_NE(values["0x0008,0x0018"], instance);
  EXPECT_EQ(values["0x0008,0x103e"], "SIMULATED ultrasound, a b " + std::string(37, 'x')) << "no half of a letter";
  EXPECT_EQ(values["0x0020,0x000d"], study) << "the study of the case";
}

TEST_F(DicomClipTest, PassesTheCheckerOfTheStandard) {
  if (!has("dciodvfy")) GTEST_SKIP() << "dciodvfy (dicom3tools) is not installed";
  for (const int channels : {1, 3})
    for (const std::vector<double>& times : {std::vector<double>{0}, {0, 0.1}, {0, 0.1, 0.3}}) {
      ASSERT_TRUE(write(clipOf(times, channels)));
      const fs::path report = folder / "report";
      const int ended = std::system(("dciodvfy '" + file.string() + "' 2>'" + report.string() + "'").c_str());
      ASSERT_NE(ended, -1);
      std::istringstream lines(test::bytesOf(report));
      for (std::string line; std::getline(lines, line);) {
        // The program is from June 2022, and does not know Synthetic Data.
        if (line.find("(0x0008,0x001c)") != std::string::npos) continue;
        EXPECT_THAT(line, testing::Not(HasSubstr("Error")));
      }
      EXPECT_THAT(test::bytesOf(report), HasSubstr("USMultiFrameImage"));
    }
}

TEST_F(DicomClipTest, NothingIsLeftAfterAFailure) {
  std::ofstream(file) << "before";
  const auto cancel = [](std::string_view, double fraction) { return fraction < 0.5; };
  EXPECT_EQ(write(clipOf({0, 1, 2, 3}), cancel).error().message, kCancelled);
  {
    const test::FullDisk full(2 * kWidth * kHeight);
    EXPECT_THAT(write(clipOf({0, 1, 2, 3})).error().message, AllOf(HasSubstr("clip.dcm"), HasSubstr("disk is full")));
  }
  EXPECT_EQ(test::bytesOf(file), "before");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  file = folder / "none" / "clip.dcm";
  EXPECT_THAT(write(clipOf({0})).error().message, HasSubstr("does not exist"));
}

TEST_F(DicomClipTest, RefusesAClipThatCannotBeWritten) {
  const auto refusal = [this](const DicomClip& clip) { return write(clip).error().message; };
  EXPECT_THAT(refusal(clipOf({})), HasSubstr("no images"));
  EXPECT_THAT(refusal(clipOf({1, 0})), HasSubstr("do not ascend"));
  DicomClip clip = clipOf({0});
  clip.region.width_px = kWidth;
  EXPECT_THAT(refusal(clip), HasSubstr("not within the frames"));
  clip = clipOf({0});
  clip.region.pixel_mm = 0;
  EXPECT_THAT(refusal(clip), HasSubstr("no scale"));
  clip = clipOf({0});
  clip.width = 65536;
  EXPECT_THAT(refusal(clip), HasSubstr("65536 x 277"));
  clip.width = clip.height = 50'000, clip.time_s = {0, 1};
  EXPECT_THAT(refusal(clip), HasSubstr("more than 4 GB"));
  std::vector<double> many;
  for (int i = 0; i < 20'000; ++i) many.push_back(i * 0.03 + (i % 2) * 0.0101);
  clip.width = clip.height = 4, clip.region = {0, 0, 4, 4, 1, 0, 0}, clip.time_s = many;
  EXPECT_THAT(refusal(clip), HasSubstr("20000 images at varying intervals"));
  clip = clipOf({0, 1});
  EXPECT_THAT(writeDicomClip(clip, file,
                             [](std::size_t, auto& pixels) -> Result<void> {
                               pixels.resize(3);
                               return {};
                             })
                  .error()
                  .message,
              HasSubstr("Image 1 of the clip has another size"));
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace insonate
