#include <insonate/simulator/ImageFiles.h>

#include <jpeglib.h>
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace insonate {
namespace {

constexpr unsigned kMaxSide = 16384;
constexpr std::size_t kMaxBytes = 256 << 20;

Error broken(const std::string& name) {
  return {name + " is damaged, or of a kind of image that cannot be read. Save it again as PNG."};
}

Error tooLarge(const std::string& name) {
  return {name + " is larger than 16384 x 16384 pixels. Make it smaller."};
}

Result<GrayImage> readPng(const std::string& bytes, const std::string& name) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return tl::unexpected(broken(name));
  if (png.width > kMaxSide || png.height > kMaxSide) {
    png_image_free(&png);
    return tl::unexpected(tooLarge(name));
  }
  png.format = PNG_FORMAT_GRAY;
  GrayImage picture{int(png.width), int(png.height), {}};
  picture.gray.resize(PNG_IMAGE_SIZE(png));
  const png_color black{0, 0, 0};
  if (png_image_finish_read(&png, &black, picture.gray.data(), 0, nullptr) == 0) return tl::unexpected(broken(name));
  return picture;
}

struct JpegFailure : jpeg_error_mgr {
  std::jmp_buf back;
};

enum class JpegEnd { Done, Broken, TooLarge };

/// Has no objects with destructors, since libjpeg's errors leave the function by longjmp.
JpegEnd decodeJpeg(const std::string& bytes, GrayImage& picture) {
  jpeg_decompress_struct jpeg{};
  JpegFailure failure{};
  jpeg.err = jpeg_std_error(&failure);
  failure.error_exit = [](j_common_ptr common) { std::longjmp(static_cast<JpegFailure*>(common->err)->back, 1); };
  failure.emit_message = [](j_common_ptr, int) {};
  if (setjmp(failure.back) != 0) {
    jpeg_destroy_decompress(&jpeg);
    return JpegEnd::Broken;
  }
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  if (jpeg.image_width > kMaxSide || jpeg.image_height > kMaxSide) {
    jpeg_destroy_decompress(&jpeg);
    return JpegEnd::TooLarge;
  }
  jpeg.out_color_space = JCS_GRAYSCALE;
  jpeg_start_decompress(&jpeg);
  picture.width = int(jpeg.output_width), picture.height = int(jpeg.output_height);
  picture.gray.resize(std::size_t(picture.width) * picture.height);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = picture.gray.data() + std::size_t(jpeg.output_scanline) * jpeg.output_width;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  jpeg_destroy_decompress(&jpeg);
  return JpegEnd::Done;
}

}  // namespace

Result<GrayImage> readGrayImage(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return fail("There is no image file named " + name + ".");
  const auto size = std::filesystem::file_size(file, error);
  if (error || size > kMaxBytes)
    return fail(name + " is larger than 256 MB, so it is not an image of an ultrasound machine. Choose another file.");
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.good() && !stream.eof()) return fail("Could not read " + name + ". Check its permissions.");
  if (bytes.starts_with("\x89PNG")) return readPng(bytes, name);
  if (!bytes.starts_with("\xff\xd8")) return fail(name + " is neither PNG nor JPEG; save the image as one of them.");
  GrayImage picture;
  switch (decodeJpeg(bytes, picture)) {
    case JpegEnd::Done:
      return picture;
    case JpegEnd::TooLarge:
      return tl::unexpected(tooLarge(name));
    case JpegEnd::Broken:
      break;
  }
  return tl::unexpected(broken(name));
}

}  // namespace insonate
