#include "realism/PictureParts.h"

#include <insonate/bench/LookFeatures.h>
#include <insonate/bench/RealismBench.h>
#include <insonate/simulator/PictureFiles.h>

#include <array>
#include <charconv>
#include <fstream>
#include <optional>

namespace insonate {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t comma = std::min(line.find(',', at), line.size());
    cells.push_back(trimmed(std::string_view(line).substr(at, comma - at)));
    at = comma + 1;
  }
  return cells;
}

std::optional<double> numberIn(const std::string& cell) {
  double value = 0;
  const char* end = cell.data() + cell.size();
  if (std::from_chars(cell.data(), end, value).ptr != end || cell.empty()) return std::nullopt;
  return value;
}

/// The part of an image inside a box of whole pixels.
Result<GreyPicture> insideOf(const GreyPicture& image, const std::vector<std::string>& box) {
  std::array<int, 4> b{};  // left, top, width, height
  for (std::size_t n = 0; n < 4; ++n) b[n] = int(numberIn(box[n]).value_or(-1));
  const auto [left, top, width, height] = b;
  if (left < 0 || top < 0 || width < 1 || height < 1 || width > image.width - left || height > image.height - top)
    return fail("The box must lie in the image, which has " + std::to_string(image.width) + " x " +
                std::to_string(image.height) + " pixels.");
  return bench::cutOut(image.grey, image.width, {left, top, width, height});
}

Result<SourceImage> imageOf(const std::vector<std::string>& cells, const std::filesystem::path& folder) {
  const auto pixelsPer_mm = cells.size() > 1 ? numberIn(cells[1]) : std::nullopt;
  if (!pixelsPer_mm || (cells.size() != 3 && cells.size() != 7) || cells[0].empty() || cells[2].empty())
    return fail(
        "It needs a file, its pixels per mm and its source, and may have left, top, width and height of the field of "
        "view in pixels, parted by commas.");
  auto image = readPicture(folder / cells[0]);
  if (image && cells.size() == 7) image = insideOf(*image, {cells.begin() + 3, cells.end()});
  if (!image) return tl::unexpected(image.error());
  auto scaled = atLookScale(*image, *pixelsPer_mm);
  if (!scaled) return tl::unexpected(scaled.error());
  return SourceImage{cells[2], cells[0], std::move(*scaled)};
}

}  // namespace

Result<std::vector<SourceImage>> readRealImages(const std::filesystem::path& list) {
  std::ifstream file(list);
  if (!file) return fail("Could not read " + list.string() + ": check that it is there and that you may read it.");
  std::vector<SourceImage> images;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (const std::string text = trimmed(line); text.empty() || text.front() == '#') continue;
    auto image = imageOf(cellsOf(line), list.parent_path());
    if (!image) return fail("Line " + std::to_string(number) + " of " + list.string() + ": " + image.error().message);
    images.push_back(std::move(*image));
  }
  if (images.empty())
    return fail(list.string() + " lists no images. Write a line `file,pixels per mm,source` for each.");
  return images;
}

}  // namespace insonate
