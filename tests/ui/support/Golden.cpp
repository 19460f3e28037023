#include "Golden.h"

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;

std::optional<Picture> readPicture(const fs::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, file.c_str())) return std::nullopt;
  png.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(png));
  if (!png_image_finish_read(&png, nullptr, picture.rgb.data(), 0, nullptr)) return std::nullopt;
  return picture;
}

bool writePicture(const Picture& picture, const fs::path& file) {
  fs::create_directories(file.parent_path());
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(picture.width), png.height = static_cast<png_uint_32>(picture.height);
  png.format = PNG_FORMAT_RGB;
  return png_image_write_to_file(&png, file.c_str(), 0, picture.rgb.data(), 0, nullptr) != 0;
}

}  // namespace

testing::AssertionResult looksLikeGolden(const Picture& picture, const std::string& name, Tolerance tolerance) {
  const fs::path golden = fs::path(INSONATE_SOURCE_DIR) / "tests/golden" / (name + ".png");
  const fs::path beside = fs::path(INSONATE_BINARY_DIR) / "Testing/golden" / name;
  if (std::getenv("INSONATE_UPDATE_GOLDEN")) {
    if (!writePicture(picture, golden)) return testing::AssertionFailure() << "could not write " << golden;
    return testing::AssertionSuccess();
  }
  const auto expected = readPicture(golden);
  if (!writePicture(picture, beside.string() + ".png"))
    return testing::AssertionFailure() << "could not write " << beside << ".png";
  if (!expected) return testing::AssertionFailure() << "no golden picture " << golden;
  if (expected->width != picture.width || expected->height != picture.height)
    return testing::AssertionFailure() << golden << " is of another size";
  Picture difference{picture.width, picture.height, std::vector<std::uint8_t>(picture.rgb.size())};
  std::size_t off = 0;
  for (std::size_t pixel = 0; pixel < picture.rgb.size(); pixel += 3) {
    int most = 0;
    for (std::size_t c = pixel; c < pixel + 3; ++c) {
      const int steps = std::abs(int(picture.rgb[c]) - int(expected->rgb[c]));
      difference.rgb[c] = static_cast<std::uint8_t>(std::min(255, 4 * steps));
      most = std::max(most, steps);
    }
    off += most > tolerance.steps;
  }
  const double share = double(off) / (double(picture.width) * picture.height);
  if (share <= tolerance.share) return testing::AssertionSuccess();
  writePicture(difference, beside.string() + "-difference.png");
  return testing::AssertionFailure() << 100 * share << " % of the pixels differ from " << golden << " by more than "
                                     << tolerance.steps << "; see " << beside << ".png and -difference.png";
}

}  // namespace insonate::test
