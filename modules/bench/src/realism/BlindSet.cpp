#include "realism/BlindSet.h"

#include "realism/PictureParts.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/core/Fingerprint.h>
#include <insonate/simulator/ImageFiles.h>

#include <jpeglib.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>
#include <string_view>
#include <utility>

namespace insonate::bench {
namespace {

constexpr int kQuality = 85;                          ///< of the JPEG compression of both sets
constexpr double kEnlarged = 2, kClipEnlarged = 1.5;  ///< enlargement of a linear probe's images for readers
constexpr int kOnASheet = 12, kColumns = 4;
constexpr int kCell_px = 340;

/// Kind by which an image could be recognized if only one of the sets had it.
using VisibleKind = std::pair<ProbeShape, bool>;

VisibleKind kindOf(const SourceImage& image) {
  return {image.probe, image.isClip()};
}

/// An image as readers see it: 20 pixels per mm for linear probes, 15 in clips, 5 for fans.
cv::Mat enlarged(const GrayImage& picture, const SourceImage& of) {
  const double factor = of.probe != ProbeShape::Linear ? 1 : of.isClip() ? kClipEnlarged : kEnlarged;
  cv::Mat large;
  cv::resize(bytesOf(picture), large, {}, factor, factor, cv::INTER_CUBIC);
  return large;
}

Result<void> writeSheet(const std::vector<GrayImage>& pictures, std::size_t first, const std::filesystem::path& file) {
  const std::size_t count = std::min<std::size_t>(kOnASheet, pictures.size() - first);
  const int rows = int((count + kColumns - 1) / kColumns);
  cv::Mat sheet(rows * kCell_px, kColumns * kCell_px, CV_8U, cv::Scalar(20));
  for (std::size_t n = 0; n < count; ++n) {
    const GrayImage& picture = pictures[first + n];
    const double fit = std::min(double(kCell_px - 30) / picture.width, double(kCell_px - 40) / picture.height);
    cv::Mat small;
    cv::resize(bytesOf(picture), small, {}, fit, fit, cv::INTER_AREA);
    const int x = int(n) % kColumns * kCell_px + 10, y = int(n) / kColumns * kCell_px + 30;
    small.copyTo(sheet(cv::Rect(x, y, small.cols, small.rows)));
    cv::putText(sheet, std::to_string(first + n + 1), {x, y - 8}, cv::FONT_HERSHEY_SIMPLEX, 0.6, cv::Scalar(200));
  }
  BModeImage image;
  image.width = sheet.cols, image.height = sheet.rows, image.pixel_mm = 1;
  image.gray.assign(sheet.datastart, sheet.dataend);
  return writePng(image, file);
}

}  // namespace

std::string jpegOf(const GrayImage& picture, int quality) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr failure{};
  jpeg.err = jpeg_std_error(&failure);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = JDIMENSION(picture.width), jpeg.image_height = JDIMENSION(picture.height);
  jpeg.input_components = 1, jpeg.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    auto* row = const_cast<JSAMPROW>(picture.gray.data() + std::size_t(jpeg.next_scanline) * jpeg.image_width);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return file;
}

BlindImages blindImages(const RealismBench& bench) {
  std::set<VisibleKind> real, made;
  for (const SourceImage& image : bench.real) real.insert(kindOf(image));
  for (const SourceImage& image : bench.simulated) made.insert(kindOf(image));
  BlindImages images;
  const auto add = [&](const SourceImage& image, bool simulated) {
    const bool isMatched = real.contains(kindOf(image)) && made.contains(kindOf(image));
    (isMatched ? images.matched : images.unmatched).push_back({&image, simulated});
  };
  for (const SourceImage& image : bench.real) add(image, false);
  for (const SourceImage& image : bench.simulated) add(image, true);
  std::mt19937 random(bench.seed);
  for (std::size_t n = images.matched.size(); n > 1; --n)
    std::swap(images.matched[n - 1], images.matched[std::uniform_int_distribution<std::size_t>(0, n - 1)(random)]);
  return images;
}

std::string numbered(std::size_t n) {
  const std::string digits = std::to_string(n + 1);
  return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

SheetItem filesOf(const BlindImage& image, std::size_t n) {
  if (!image.image->isClip()) return {{numbered(n) + ".jpg"}};
  SheetItem item;
  for (std::size_t frame = 0; frame < image.image->frames.size(); ++frame)
    item.files.push_back(numbered(n) + "/" + numbered(frame) + ".jpg");
  return item;
}

Result<std::vector<GrayImage>> writeImages(const std::vector<BlindImage>& images, const std::filesystem::path& folder) {
  std::vector<GrayImage> middles;
  for (std::size_t n = 0; n < images.size(); ++n) {
    const SourceImage& image = *images[n].image;
    const SheetItem item = filesOf(images[n], n);
    if (image.isClip()) {
      std::error_code error;
      std::filesystem::create_directories(folder / numbered(n), error);
      if (error) return fail("Could not make a folder in " + folder.string() + ": " + error.message() + ".");
    }
    for (std::size_t frame = 0; frame < item.files.size(); ++frame) {
      const GrayImage large = pictureOf(enlarged(image.isClip() ? image.frames[frame] : image.shown(), image));
      if (auto ok = writeAtomically(folder / item.files[frame], jpegOf(large, kQuality)); !ok)
        return tl::unexpected(ok.error());
    }
    auto compressed = readGrayImage(folder / item.files[item.files.size() / 2]);
    if (!compressed) return tl::unexpected(compressed.error());
    middles.push_back(std::move(*compressed));
  }
  return middles;
}

Result<void> writeBlindSet(const std::vector<BlindImage>& images, const std::filesystem::path& folder) {
  const auto pictures = writeImages(images, folder);
  if (!pictures) return tl::unexpected(pictures.error());
  std::string ratings = "number,rating\n";
  std::vector<SheetItem> items;
  Fingerprint fingerprint;
  bool hasClips = false;
  for (std::size_t n = 0; n < images.size(); ++n) {
    ratings += std::to_string(n + 1) + ",\n";
    items.push_back(filesOf(images[n], n));
    const std::vector<std::uint8_t>& gray = (*pictures)[n].gray;
    fingerprint.add(std::string_view(reinterpret_cast<const char*>(gray.data()), gray.size()));
    hasClips = hasClips || images[n].image->isClip();
  }
  for (std::size_t first = 0; first < pictures->size(); first += kOnASheet)
    if (auto ok = writeSheet(*pictures, first, folder / ("sheet-" + std::to_string(first / kOnASheet + 1) + ".png"));
        !ok)
      return ok;
  if (auto ok = writeAtomically(folder / "instructions.md", readerInstructions(images.size(), hasClips)); !ok)
    return ok;
  if (auto ok = writeAtomically(folder / "ratings.csv", ratings); !ok) return ok;
  return writeAtomically(folder / "sheet.html", sheetHtml(items, fingerprint.text()));
}

}  // namespace insonate::bench
