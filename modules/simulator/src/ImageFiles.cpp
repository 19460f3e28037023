#include <insonate/core/AtomicFile.h>
#include <insonate/simulator/ImageFiles.h>

#include <png.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace insonate {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Owns libpng's state, and converts its errors to exceptions.
class PngWriter {
 public:
  PngWriter() {
    png_ = png_create_write_struct(
        PNG_LIBPNG_VER_STRING, nullptr, [](png_structp, png_const_charp text) { throw std::runtime_error(text); },
        nullptr);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) throw std::bad_alloc();
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  /// `pixels` has one byte (gray) or three bytes (RGB) for each pixel of the image.
  void write(const BModeImage& image, const std::vector<std::uint8_t>& pixels, std::FILE* file) {
    png_init_io(png_, file);
    const auto width = static_cast<png_uint_32>(image.width), height = static_cast<png_uint_32>(image.height);
    const std::size_t perPixel = pixels.size() / std::max<std::size_t>(std::size_t(width) * height, 1);
    png_set_IHDR(png_, info_, width, height, 8, perPixel == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    const auto perMetre = static_cast<png_uint_32>(std::lround(1000 / image.pixel_mm));
    png_set_pHYs(png_, info_, perMetre, perMetre, PNG_RESOLUTION_METER);
    png_write_info(png_, info_);
    for (int row = 0; row < image.height; ++row)
      png_write_row(png_, pixels.data() + std::size_t(row) * image.width * perPixel);
    png_write_end(png_, info_);
  }

 private:
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

std::string nrrdHeader(const EnvelopeFrame& envelope, const Probe& probe, const ImagingSettings& settings) {
  const BeamGrid grid(probe, settings);
  const bool fan = probe.shape != ProbeShape::Linear;
  const Vec3 first = grid.direction(0), second = grid.direction(1);
  const double across = fan ? std::atan2(norm(cross(first, second)), dot(first, second)) * 180 / std::numbers::pi
                            : grid.scanlineSpacing_mm(0);
  std::ostringstream header;
  header.precision(12);
  header << "NRRD0004\n"
         << "content: linear echo amplitude of one look, sample by scanline\n"
         << "type: float\n"
         << "dimension: 2\n"
         << "sizes: " << envelope.samples << ' ' << envelope.scanlines << '\n'
         << "spacings: " << grid.step_mm() << ' ' << across << '\n'
         << "axis mins: " << grid.range_mm(0) << ' ' << -across * (envelope.scanlines - 1) / 2 << '\n'
         << "labels: \"sample\" \"scanline\"\n"
         << "units: \"mm\" \"" << (fan ? "deg" : "mm") << "\"\n"
         << "encoding: raw\n"
         << "endian: " << (std::endian::native == std::endian::little ? "little" : "big") << '\n'
         << "frequency_MHz:=" << settings.frequency_MHz << '\n'
         << '\n';
  return header.str();
}

/// The image in RGB with color over it, and the scale of the colors in the upper right corner.
std::vector<std::uint8_t> coloredPixels(const BModeImage& image, const ColorImage& color) {
  std::vector<std::uint8_t> rgb(std::size_t(image.width) * image.height * 3);
  for (std::size_t i = 0; i < image.gray.size(); ++i) rgb[3 * i] = rgb[3 * i + 1] = rgb[3 * i + 2] = image.gray[i];
  const auto pixel = [&](int row, int column) { return rgb.data() + (std::size_t(row) * image.width + column) * 3; };
  for (int row = 0; row < color.height; ++row)
    for (int column = 0; column < color.width; ++column)
      if (const auto* from = color.rgba.data() + (std::size_t(row) * color.width + column) * 4; from[3] != 0)
        std::copy_n(from, 3, pixel(color.row + row, color.column + column));
  constexpr int kWidth = 12, kMargin = 10, kPerShade = 2;
  const auto shades = static_cast<int>(color.scale.size());
  const int height = std::min(kPerShade * shades, image.height - 2 * kMargin);
  for (int row = 0; row < height && image.width > kWidth + kMargin; ++row)
    for (int column = 0; column < kWidth; ++column)
      std::ranges::copy(color.scale[(height - 1 - row) * shades / height],
                        pixel(kMargin + row, image.width - kMargin - kWidth + column));
  return rgb;
}

Result<void> writePixels(const BModeImage& image, const std::vector<std::uint8_t>& pixels,
                         const std::filesystem::path& target) {
  return writeAtomically(target, [&](const std::filesystem::path& beside) -> Result<void> {
    const std::string error =
        "Could not write " + target.string() +
        ": the disk is full or the folder cannot be written. Free space or choose another folder.";
    const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(beside.c_str(), "wb"));
    if (!file) return fail(error);
    try {
      PngWriter().write(image, pixels, file.get());
    } catch (const std::runtime_error&) {  // the text of the exception is "Write Error"
      return fail(error);
    }
    if (std::fflush(file.get()) != 0) return fail(error);
    return {};
  });
}

}  // namespace

Result<void> writePng(const BModeImage& image, const std::filesystem::path& file) {
  return writePixels(image, image.gray, file);
}

Result<void> writePng(const BModeImage& image, const ColorImage& color, const std::filesystem::path& file) {
  return color.empty() ? writePng(image, file) : writePixels(image, coloredPixels(image, color), file);
}

Result<void> writeEnvelope(const EnvelopeFrame& envelope, const Probe& probe, const ImagingSettings& settings,
                           const std::filesystem::path& file, int look) {
  const std::string header = nrrdHeader(envelope, probe, settings);
  std::string bytes(header.size() + sizeof(float) * envelope.samples * envelope.scanlines, '\0');
  header.copy(bytes.data(), header.size());
  char* out = bytes.data() + header.size();
  const float* in = envelope.look(look);
  for (int line = 0; line < envelope.scanlines; ++line)
    for (int sample = 0; sample < envelope.samples; ++sample, out += sizeof(float))
      std::memcpy(out, in + std::size_t(sample) * envelope.scanlines + line, sizeof(float));
  return writeAtomically(file, bytes);
}

}  // namespace insonate
