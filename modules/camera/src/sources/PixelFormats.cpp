#include "sources/PixelFormats.h"

#include <jpeglib.h>

#include <csetjmp>
#include <cstdio>  // jpeglib.h needs FILE

namespace insonate::camera {
namespace {

/// Errors of libjpeg come back by longjmp; nothing between setjmp and longjmp may have a destructor.
struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf back;
};

void jumpBack(j_common_ptr jpeg) {
  std::longjmp(reinterpret_cast<JpegErrors*>(jpeg->err)->back, 1);
}
void ignoreMessage(j_common_ptr, int level) {
  (void)level;
}
void printNothing(j_common_ptr) {}

bool decode(const std::uint8_t* bytes, std::size_t count, int width, int height, std::uint8_t* gray) {
  jpeg_decompress_struct jpeg{};
  JpegErrors errors{};
  jpeg.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = jumpBack;
  errors.manager.emit_message = ignoreMessage;
  errors.manager.output_message = printNothing;
  if (setjmp(errors.back)) {
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, bytes, static_cast<unsigned long>(count));
  jpeg_read_header(&jpeg, TRUE);
  const bool fits = int(jpeg.image_width) == width && int(jpeg.image_height) == height;
  if (fits) {
    jpeg.out_color_space = JCS_GRAYSCALE;
    jpeg.dct_method = JDCT_IFAST;
    jpeg_start_decompress(&jpeg);
    while (jpeg.output_scanline < jpeg.output_height) {
      JSAMPROW row = gray + std::size_t(jpeg.output_scanline) * std::size_t(width);
      jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
  }
  jpeg_destroy_decompress(&jpeg);
  return fits;
}

bool copyRows(std::span<const std::uint8_t> bytes, int width, int height, std::size_t stride, std::size_t step,
              std::vector<std::uint8_t>& gray) {
  const auto w = std::size_t(width), h = std::size_t(height);
  if (stride < w * step || bytes.size() < stride * (h - 1) + w * step) return false;
  gray.resize(w * h);
  for (std::size_t y = 0; y < h; ++y)
    for (std::size_t x = 0; x < w; ++x) gray[y * w + x] = bytes[y * stride + x * step];
  return true;
}

}  // namespace

bool grayFromYuyv(std::span<const std::uint8_t> bytes, int width, int height, std::size_t stride,
                  std::vector<std::uint8_t>& gray) {
  return copyRows(bytes, width, height, stride, 2, gray);
}

bool grayFromGray(std::span<const std::uint8_t> bytes, int width, int height, std::size_t stride,
                  std::vector<std::uint8_t>& gray) {
  return copyRows(bytes, width, height, stride, 1, gray);
}

bool grayFromJpeg(std::span<const std::uint8_t> bytes, int width, int height, std::vector<std::uint8_t>& gray) {
  gray.resize(std::size_t(width) * std::size_t(height));
  return decode(bytes.data(), bytes.size(), width, height, gray.data());
}

}  // namespace insonate::camera
