#include "support/FullDisk.h"
#include "support/TestData.h"

#include <insonate/simulator/ImageFiles.h>

#include <gmock/gmock.h>
#include <png.h>

#include <cstring>
#include <fstream>
#include <iterator>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

BModeImage gradient() {
  BModeImage image{.width = 70, .height = 64, .pixel_mm = 0.05, .gray = std::vector<std::uint8_t>(70 * 64)};
  for (std::size_t i = 0; i < image.gray.size(); ++i) image.gray[i] = static_cast<std::uint8_t>(i * 7);
  return image;
}

bool isEmpty(const test::TemporaryFolder& folder) {
  return fs::directory_iterator(folder.path()) == fs::directory_iterator();
}

TEST(WritePng, ReadsBackWithItsScale) {
  const test::TemporaryFolder folder;
  const BModeImage image = gradient();
  const std::string file = (folder / "picture.png").string();
  const auto written = writePng(image, file);
  ASSERT_TRUE(written) << written.error().message;

  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::FILE* stream = std::fopen(file.c_str(), "rb");
  ASSERT_NE(stream, nullptr);
  png_init_io(png, stream);
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  EXPECT_EQ(png_get_image_width(png, info), 70u);
  EXPECT_EQ(png_get_image_height(png, info), 64u);
  EXPECT_EQ(png_get_bit_depth(png, info), 8);
  EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_GRAY);
  EXPECT_EQ(png_get_pixels_per_meter(png, info), 20000u);
  const png_bytepp rows = png_get_rows(png, info);
  for (int row = 0; row < 64; ++row) EXPECT_EQ(std::memcmp(rows[row], image.gray.data() + row * 70, 70), 0) << row;
  std::fclose(stream);
  png_destroy_read_struct(&png, &info, nullptr);
}

TEST(WritePng, AMissingFolderIsRefused) {
  const test::TemporaryFolder folder;
  const auto written = writePng(gradient(), folder / "none" / "picture.png");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("does not exist"));
  EXPECT_TRUE(isEmpty(folder));
}

TEST(WritePng, AFullDiskLeavesTheOldPictureAndASentence) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "picture.png") << "old";
  Result<void> written;
  {
    const test::FullDisk full(100);
    written = writePng(gradient(), folder / "picture.png");
  }
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, testing::AllOf(HasSubstr("picture.png"), HasSubstr("disk is full")));
  EXPECT_EQ(fs::file_size(folder / "picture.png"), 3u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

struct Nrrd {
  std::string header;
  std::vector<float> values;
};

Nrrd readNrrd(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const auto end = bytes.find("\n\n");
  EXPECT_NE(end, bytes.npos);
  std::vector<float> values((bytes.size() - end - 2) / sizeof(float));
  std::memcpy(values.data(), bytes.data() + end + 2, values.size() * sizeof(float));
  return {bytes.substr(0, end + 1), values};
}

EnvelopeFrame numbered(const ImagingSettings& settings) {
  EnvelopeFrame envelope;
  envelope.resize(settings.scanlines, settings.samples, 2);
  for (std::size_t i = 0; i < envelope.amplitude.size(); ++i) envelope.amplitude[i] = static_cast<float>(i);
  return envelope;
}

TEST(WriteEnvelope, HasSamplesFastestAndItsSpacings) {
  const test::TemporaryFolder folder;
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = 16;
  settings.samples = 64;
  ASSERT_TRUE(writeEnvelope(numbered(settings), probe, settings, folder / "e.nrrd", 1));
  const Nrrd nrrd = readNrrd(folder / "e.nrrd");
  EXPECT_THAT(nrrd.header, testing::StartsWith("NRRD0004\n"));
  EXPECT_THAT(nrrd.header, HasSubstr("\nsizes: 64 16\n"));
  EXPECT_THAT(nrrd.header, HasSubstr("\nspacings: 0.625 2.375\n"));
  EXPECT_THAT(nrrd.header, HasSubstr("\nunits: \"mm\" \"mm\"\n"));
  ASSERT_EQ(nrrd.values.size(), 64u * 16);
  EXPECT_EQ(nrrd.values[0], 1024);
  EXPECT_EQ(nrrd.values[1], 1024 + 16) << "the next sample of the same scanline";
  EXPECT_EQ(nrrd.values[64], 1024 + 1) << "the first sample of the next scanline";
}

TEST(WriteEnvelope, AFanCountsInDegrees) {
  const test::TemporaryFolder folder;
  const Probe probe = *loadProbe("phased");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = 16;
  settings.samples = 64;
  ASSERT_TRUE(writeEnvelope(numbered(settings), probe, settings, folder / "e.nrrd"));
  EXPECT_THAT(readNrrd(folder / "e.nrrd").header, HasSubstr("\nunits: \"mm\" \"deg\"\n"));
}

}  // namespace
}  // namespace insonate
