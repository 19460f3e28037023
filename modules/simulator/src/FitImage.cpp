#include <insonate/core/AtomicFile.h>
#include <insonate/simulator/ImageFiles.h>

#include <png.h>

#include <array>
#include <cmath>
#include <cstring>

namespace insonate {
namespace {

using Color = std::array<std::uint8_t, 3>;
constexpr Color kOutline{74, 163, 216}, kMarks{224, 163, 58};

class Canvas {
 public:
  explicit Canvas(const GrayImage& picture)
      : wide_(picture.width), high_(picture.height), rgb_(picture.gray.size() * 3) {
    for (std::size_t k = 0; k < rgb_.size(); ++k) rgb_[k] = picture.gray[k / 3];
  }

  void dot(PixelPoint at, const Color& color) {
    const int x = int(std::lround(at.x)), y = int(std::lround(at.y));
    for (int row = std::max(0, y); row <= std::min(high_ - 1, y + 1); ++row)
      for (int column = std::max(0, x); column <= std::min(wide_ - 1, x + 1); ++column)
        std::memcpy(rgb_.data() + 3 * (std::size_t(row) * wide_ + column), color.data(), 3);
  }

  void line(PixelPoint from, PixelPoint to, const Color& color) {
    const int steps = std::max(1, int(std::ceil(std::hypot(to.x - from.x, to.y - from.y))));
    for (int k = 0; k <= steps; ++k)
      dot({from.x + (to.x - from.x) * k / steps, from.y + (to.y - from.y) * k / steps}, color);
  }

  bool write(const std::filesystem::path& file) const {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(wide_), png.height = png_uint_32(high_), png.format = PNG_FORMAT_RGB;
    return png_image_write_to_file(&png, file.c_str(), 0, rgb_.data(), 0, nullptr) != 0;
  }

 private:
  int wide_, high_;
  std::vector<std::uint8_t> rgb_;
};

/// Points far outside the image are not drawn, however large a fit is.
bool near(PixelPoint p, const GrayImage& picture) {
  return std::abs(p.x) < 3.0 * picture.width + 1000 && std::abs(p.y) < 3.0 * picture.height + 1000;
}

}  // namespace

Result<void> writeFitImage(const GrayImage& picture, const FovFit& fit, const std::filesystem::path& file) {
  Canvas canvas(picture);
  const std::vector<PixelPoint> outline = outlineOf(fit.shape);
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const PixelPoint &from = outline[k], &to = outline[(k + 1) % outline.size()];
    if (near(from, picture) && near(to, picture)) canvas.line(from, to, kOutline);
  }
  if (fit.ruler)
    for (const PixelPoint& mark : fit.ruler->at) canvas.line({mark.x - 6, mark.y}, {mark.x + 6, mark.y}, kMarks);
  return writeAtomically(file, [&](const std::filesystem::path& beside) -> Result<void> {
    if (canvas.write(beside)) return {};
    return fail("Could not write " + file.string() +
                ": the disk is full or the folder cannot be written. Free space or choose another folder.");
  });
}

}  // namespace insonate
