#include "realism/FanInside.h"

#include <insonate/bench/AppearanceFeatures.h>
#include <insonate/bench/SourceImage.h>
#include <insonate/simulator/ImageFiles.h>
#include <insonate/ultrasound/SetupText.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
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
Result<GrayImage> insideOf(const GrayImage& image, const std::vector<std::string>& box) {
  std::array<int, 4> b{};  // left, top, width, height
  for (std::size_t n = 0; n < 4; ++n) b[n] = int(numberIn(box[n]).value_or(-1));
  const auto [left, top, width, height] = b;
  if (left < 0 || top < 0 || width < 1 || height < 1 || width > image.width - left || height > image.height - top)
    return fail("The box must lie in the image, which has " + std::to_string(image.width) + " x " +
                std::to_string(image.height) + " pixels.");
  return bench::cutOut(image.gray, image.width, {left, top, width, height});
}

/// One line of the list.
struct Entry {
  std::filesystem::path file;
  std::string name, source;
  double pixelsPer_mm = 0, framesPer_s = kClipFrames_perSecond;
  std::vector<std::string> box;  ///< four cells, or empty
  ProbeShape probe = ProbeShape::Linear;
  std::optional<ScanPlane> plane;
};

/// Reads a cell `key=value`.
Result<void> readOption(const std::string& cell, Entry& entry) {
  const std::size_t equals = cell.find('=');
  const std::string key = trimmed(std::string_view(cell).substr(0, equals));
  const std::string value = trimmed(std::string_view(cell).substr(equals + 1));
  if (key == "probe") {
    for (const ProbeShape shape : {ProbeShape::Linear, ProbeShape::Curvilinear, ProbeShape::Phased})
      if (nameOf(shape) == value) {
        entry.probe = shape;
        return {};
      }
    return fail("The probe is linear, curvilinear or phased, not \"" + value + "\".");
  }
  if (key == "plane") {
    entry.plane = scanPlaneNamed(value);
    if (!entry.plane) return fail("The plane is transverse, longitudinal or oblique, not \"" + value + "\".");
    return {};
  }
  if (key == "fps") {
    entry.framesPer_s = numberIn(value).value_or(0);
    if (!(entry.framesPer_s >= 5 && entry.framesPer_s <= 500))
      return fail("A clip has 5 to 500 frames per second, not \"" + value + "\".");
    return {};
  }
  return fail("\"" + key + "\" is none of probe, plane and fps.");
}

Result<Entry> entryOf(const std::vector<std::string>& cells, const std::filesystem::path& folder) {
  const auto isOption = [](const std::string& cell) { return cell.find('=') != std::string::npos; };
  const auto options =
      std::find_if(cells.begin() + std::min<std::ptrdiff_t>(3, std::ssize(cells)), cells.end(), isOption);
  const std::ptrdiff_t plain = options - cells.begin();
  const auto pixelsPer_mm = cells.size() > 1 ? numberIn(cells[1]) : std::nullopt;
  if (!pixelsPer_mm || (plain != 3 && plain != 7) || cells[0].empty() || cells[2].empty())
    return fail(
        "It needs a file, its pixels per mm and its source, and may have left, top, width and height of the field of "
        "view in pixels, then probe=, plane= and fps=, separated by commas.");
  Entry entry{.file = folder / cells[0], .name = cells[0], .source = cells[2], .box = {}, .plane = {}};
  entry.pixelsPer_mm = *pixelsPer_mm;
  if (plain == 7) entry.box.assign(cells.begin() + 3, cells.begin() + 7);
  for (auto cell = options; cell != cells.end(); ++cell)
    if (auto ok = readOption(*cell, entry); !ok) return tl::unexpected(ok.error());
  return entry;
}

/// Files of the middle second of a clip, in order.
Result<std::vector<std::filesystem::path>> framesIn(const Entry& entry) {
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(entry.file))
    if (file.is_regular_file()) files.push_back(file.path());
  std::ranges::sort(files);
  const double second = entry.framesPer_s, most = double(files.size());
  if (most + 0.5 < second)
    return fail("The folder " + entry.file.string() + " holds " + std::to_string(files.size()) +
                " images; a clip of 1 s needs " + std::to_string(int(std::lround(second))) +
                ". If it has fewer frames per second, write fps=.");
  std::vector<std::filesystem::path> frames;
  for (int n = 0; n < kClipFrames; ++n) {
    const double at = (most - second) / 2 + second * n / kClipFrames;
    frames.push_back(files[std::min(files.size() - 1, std::size_t(std::max(0.0, at)))]);
  }
  return frames;
}

Result<GrayImage> readBox(const std::filesystem::path& file, const std::vector<std::string>& box) {
  auto image = readGrayImage(file);
  if (image && !box.empty()) image = insideOf(*image, box);
  return image;
}

/// The inside of the fan that an image shows.
Result<cv::Mat> fanMask(const GrayImage& image, ProbeShape probe) {
  const auto fit = fitFov(image);
  if (!fit) return tl::unexpected(fit.error());
  if (fit->shape.shape == ProbeShape::Linear || fit->confidence < 0.5)
    return fail("No clear fan of a " + std::string(nameOf(probe)) +
                " probe was found. Give the box of its field of view, without a second image beside it.");
  std::vector<cv::Point> outline;
  for (const PixelPoint& p : outlineOf(fit->shape)) outline.emplace_back(int(std::lround(p.x)), int(std::lround(p.y)));
  cv::Mat mask = cv::Mat::zeros(image.height, image.width, CV_8U);
  cv::fillPoly(mask, std::vector{outline}, cv::Scalar(255));
  return mask;
}

Result<SourceImage> imageOf(const Entry& entry) {
  std::error_code error;
  const bool isClip = std::filesystem::is_directory(entry.file, error);
  std::vector<std::filesystem::path> files{entry.file};
  if (isClip) {
    auto found = framesIn(entry);
    if (!found) return tl::unexpected(found.error());
    files = std::move(*found);
  }
  SourceImage one{entry.source, entry.name, {}, entry.probe, entry.plane};
  const auto middle = readBox(files[files.size() / 2], entry.box);
  if (!middle) return tl::unexpected(middle.error());
  cv::Mat mask;
  PixelBox measured{0, 0, middle->width, middle->height};
  if (entry.probe != ProbeShape::Linear) {
    auto fan = fanMask(*middle, entry.probe);
    if (!fan) return tl::unexpected(fan.error());
    mask = std::move(*fan), measured = bench::largestRectangle(mask);
  }
  const auto measuredPart = [&](const GrayImage& image) {
    return atFeatureScale(bench::cutOut(image.gray, image.width, measured), entry.pixelsPer_mm);
  };
  auto scaled = measuredPart(*middle);
  if (!scaled) return tl::unexpected(scaled.error());
  one.image = std::move(*scaled);
  if (!isClip && mask.empty()) return one;
  for (const std::filesystem::path& file : files) {
    const auto image = readBox(file, entry.box);
    if (!image) return tl::unexpected(image.error());
    if (image->width != middle->width || image->height != middle->height)
      return fail("The frames of the clip " + entry.file.string() + " differ in size.");
    auto frame = mask.empty() ? measuredPart(*image)
                              : bench::atShownScale(bench::onlyInside(*image, mask), entry.pixelsPer_mm, entry.probe);
    if (!frame) return tl::unexpected(frame.error());
    one.frames.push_back(std::move(*frame));
  }
  return one;
}

}  // namespace

Result<std::vector<SourceImage>> readRealImages(const std::filesystem::path& list) {
  std::ifstream file(list);
  if (!file) return fail("Could not read " + list.string() + ": check that it is there and that you may read it.");
  std::vector<SourceImage> images;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (const std::string text = trimmed(line); text.empty() || text.front() == '#') continue;
    const auto entry = entryOf(cellsOf(line), list.parent_path());
    auto image = entry ? imageOf(*entry) : tl::unexpected(entry.error());
    if (!image) return fail("Line " + std::to_string(number) + " of " + list.string() + ": " + image.error().message);
    images.push_back(std::move(*image));
  }
  if (images.empty())
    return fail(list.string() + " lists no images. Write a line `file,pixels per mm,source` for each.");
  return images;
}

}  // namespace insonate
