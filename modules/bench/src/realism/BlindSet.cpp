#include "realism/BlindSet.h"

#include "realism/PictureParts.h"

#include <insonate/bench/LookFeatures.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/simulator/PictureFiles.h>

#include <jpeglib.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace insonate::bench {
namespace {

constexpr int kQuality = 85;     ///< of the JPEG compression of both sets
constexpr double kEnlarged = 2;  ///< enlargement for readers: 20 pixels per mm
constexpr int kOnASheet = 12, kColumns = 4;
constexpr int kCell_px = 340;

constexpr const char* kInstructions =
    R"(# Which of these ultrasound images are simulated?

Some of the numbered images are of patients, from several machines, the others are simulated. How many of each is not told.

1. Look at each image once, in the order of the numbers, on the screen and in the light in which you read scans.
2. Rate each from 1 to 6: 1 surely real, 2 probably real, 3 rather real, 4 rather simulated, 5 probably simulated, 6 surely
   simulated. Do not go back to change a rating.
3. Write the ratings into ratings.csv, or open sheet.html, choose them there and save them.
4. Do not talk about the images with other readers before they are done, and do not rate a set a second time: clues that are
   known make a second reading better.
5. Note below the ratings, after a #, what gave images away, and who you are as a reader (e.g. sonographer, 8 years).

All images show the inside of the field of view of a linear probe on a neck, at the same scale, compressed alike.
)";

std::string numbered(std::size_t n) {
  const std::string digits = std::to_string(n + 1);
  return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

cv::Mat enlarged(const GreyPicture& picture) {
  cv::Mat large;
  cv::resize(bytesOf(picture), large, {}, kEnlarged, kEnlarged, cv::INTER_CUBIC);
  return large;
}

std::string sheetHtml(std::size_t count) {
  std::string html = R"(<!doctype html><html lang="en"><meta charset="utf-8"><title>Blind test</title><style>
body{background:#111;color:#ccc;font:15px sans-serif;margin:2em}figure{display:inline-block;margin:1em;vertical-align:top}
img{display:block}button{font:inherit;padding:.5em 1em}</style>
<h1>Which are simulated?</h1><p>1 surely real ... 6 surely simulated. See instructions.md.</p>
)";
  for (std::size_t n = 0; n < count; ++n) {
    html += "<figure><img src=\"" + numbered(n) + ".jpg\" alt=\"\"><figcaption>" + std::to_string(n + 1);
    for (int rating = 1; rating <= 6; ++rating)
      html += " <label><input type=\"radio\" name=\"" + std::to_string(n + 1) + "\" value=\"" + std::to_string(rating) +
              "\">" + std::to_string(rating) + "</label>";
    html += "</figcaption></figure>\n";
  }
  return html + R"(<p><button>Save Ratings</button></p><script>
document.querySelector('button').onclick=()=>{let rows=['number,rating'];
document.querySelectorAll('input:checked').forEach(i=>rows.push(i.name+','+i.value));
let a=document.createElement('a');a.href=URL.createObjectURL(new Blob([rows.join('\n')+'\n'],{type:'text/csv'}));
a.download='ratings.csv';a.click();};</script></html>
)";
}

Result<void> writeSheet(const std::vector<GreyPicture>& pictures, std::size_t first,
                        const std::filesystem::path& file) {
  const std::size_t count = std::min<std::size_t>(kOnASheet, pictures.size() - first);
  const int rows = int((count + kColumns - 1) / kColumns);
  cv::Mat sheet(rows * kCell_px, kColumns * kCell_px, CV_8U, cv::Scalar(20));
  for (std::size_t n = 0; n < count; ++n) {
    const GreyPicture& picture = pictures[first + n];
    const double fit = std::min(double(kCell_px - 30) / picture.width, double(kCell_px - 40) / picture.height);
    cv::Mat small;
    cv::resize(bytesOf(picture), small, {}, fit, fit, cv::INTER_AREA);
    const int x = int(n) % kColumns * kCell_px + 10, y = int(n) / kColumns * kCell_px + 30;
    small.copyTo(sheet(cv::Rect(x, y, small.cols, small.rows)));
    cv::putText(sheet, std::to_string(first + n + 1), {x, y - 8}, cv::FONT_HERSHEY_SIMPLEX, 0.6, cv::Scalar(200));
  }
  BModeImage image;
  image.width = sheet.cols, image.height = sheet.rows, image.pixel_mm = 1;
  image.grey.assign(sheet.datastart, sheet.dataend);
  return writePng(image, file);
}

}  // namespace

std::string jpegOf(const GreyPicture& picture, int quality) {
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
    auto* row = const_cast<JSAMPROW>(picture.grey.data() + std::size_t(jpeg.next_scanline) * jpeg.image_width);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return file;
}

std::vector<BlindImage> shuffled(const RealismBench& bench) {
  std::vector<BlindImage> images;
  for (const SourceImage& image : bench.real) images.push_back({&image, false});
  for (const SourceImage& image : bench.simulated) images.push_back({&image, true});
  std::mt19937 random(bench.seed);
  for (std::size_t n = images.size(); n > 1; --n)
    std::swap(images[n - 1], images[std::uniform_int_distribution<std::size_t>(0, n - 1)(random)]);
  return images;
}

Result<void> writeBlindSet(const std::vector<BlindImage>& images, const std::filesystem::path& folder) {
  std::string ratings = "number,rating\n";
  std::vector<GreyPicture> pictures;
  for (std::size_t n = 0; n < images.size(); ++n) {
    const GreyPicture large = pictureOf(enlarged(images[n].image->image));
    const std::filesystem::path file = folder / (numbered(n) + ".jpg");
    if (auto ok = writeAtomically(file, jpegOf(large, kQuality)); !ok) return ok;
    auto compressed = readPicture(file);
    if (!compressed) return tl::unexpected(compressed.error());
    pictures.push_back(std::move(*compressed));
    ratings += std::to_string(n + 1) + ",\n";
  }
  for (std::size_t first = 0; first < pictures.size(); first += kOnASheet)
    if (auto ok = writeSheet(pictures, first, folder / ("sheet-" + std::to_string(first / kOnASheet + 1) + ".png"));
        !ok)
      return ok;
  if (auto ok = writeAtomically(folder / "instructions.md", kInstructions); !ok) return ok;
  if (auto ok = writeAtomically(folder / "ratings.csv", ratings); !ok) return ok;
  return writeAtomically(folder / "sheet.html", sheetHtml(images.size()));
}

}  // namespace insonate::bench
