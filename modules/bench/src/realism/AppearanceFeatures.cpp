#include "realism/PictureParts.h"

#include <insonate/bench/AppearanceFeatures.h>
#include <insonate/bench/SourceImage.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace insonate {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
constexpr double kSmooth_px = 1.5;  ///< standard deviation of the blur that removes fine detail, 0.15 mm
constexpr int kAround_px = 9;       ///< radius of local contrast
constexpr int kBands = 3, kBand_mm = 10;

std::vector<double> valuesOf(const cv::Mat& image) {
  std::vector<double> values;
  values.reserve(image.total());
  for (int y = 0; y < image.rows; ++y)
    values.insert(values.end(), image.ptr<float>(y), image.ptr<float>(y) + image.cols);
  return values;
}

double share(const cv::Mat& mask) {
  return double(cv::countNonZero(mask)) / double(mask.total());
}

double meanOf(const cv::Mat& image) {
  return cv::mean(image)[0];
}

double deviationOf(const cv::Mat& image) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(image, mean, deviation);
  return deviation[0];
}

cv::Mat blurred(const cv::Mat& image) {
  const int size = 2 * int(std::lround(4 * kSmooth_px)) + 1;
  cv::Mat smooth;
  cv::GaussianBlur(image, smooth, {size, size}, kSmooth_px, kSmooth_px, cv::BORDER_REFLECT);
  return smooth;
}

/// Bright ridges along the face: minus the second derivative of a Gaussian over depth, where positive.
cv::Mat ridgesOf(const cv::Mat& image) {
  const int reach = int(std::lround(4 * kSmooth_px));
  cv::Mat kernel(2 * reach + 1, 1, CV_32F);
  double sum = 0;
  for (int n = -reach; n <= reach; ++n) sum += std::exp(-n * n / (2 * kSmooth_px * kSmooth_px));
  for (int n = -reach; n <= reach; ++n) {
    const double s2 = kSmooth_px * kSmooth_px;
    kernel.at<float>(n + reach) = float(-(n * n / (s2 * s2) - 1 / s2) * std::exp(-n * n / (2 * s2)) / sum);
  }
  cv::Mat ridges;
  cv::filter2D(image, ridges, CV_32F, kernel, {-1, -1}, 0, cv::BORDER_REFLECT);
  return cv::max(ridges, 0);
}

class Measuring {
 public:
  explicit Measuring(const GrayImage& image)
      : image_([&] {
          cv::Mat floats;
          bench::bytesOf(image).convertTo(floats, CV_32F);
          return floats;
        }()),
        smooth_(blurred(image_)),
        mean_(std::max(1e-6, meanOf(image_))) {}

  std::vector<AppearanceFeature> features() {
    grays();
    contrast();
    detail("lateral", image_);
    cv::Mat turned;
    cv::transpose(image_, turned);
    detail("axial", turned);
    edges();
    ridges();
    for (int band = 0; band < kBands; ++band) depthBand(band);
    return std::move(features_);
  }

 private:
  void add(std::string name, double value) { features_.push_back({std::move(name), value}); }

  void grays() {
    const std::vector<double> values = valuesOf(image_);
    for (const int percent : {5, 25, 50, 75, 95, 99})
      add("gray p" + std::to_string(percent), bench::quantile(values, percent / 100.0));
    add("share below gray 6", share(image_ < 6));
    add("share above gray 200", share(image_ > 200));
    const int quarter = image_.rows / 4;
    add("deep / shallow quarter", meanOf(image_.rowRange(image_.rows - quarter, image_.rows)) /
                                      std::max(1e-6, meanOf(image_.rowRange(0, quarter))));
  }

  /// Standard deviation over mean of small patches that are not black.
  void contrast() {
    add("fine detail / mean", deviationOf(image_ - smooth_) / mean_);
    cv::Mat mean, square;
    cv::blur(image_, mean, {kAround_px, kAround_px}, {-1, -1}, cv::BORDER_REFLECT);
    cv::blur(image_.mul(image_), square, {kAround_px, kAround_px}, {-1, -1}, cv::BORDER_REFLECT);
    std::vector<double> variation;
    for (int y = 0; y < image_.rows; ++y)
      for (int x = 0; x < image_.cols; ++x) {
        if (smooth_.at<float>(y, x) <= 15) continue;
        const float m = mean.at<float>(y, x);
        variation.push_back(std::sqrt(std::max(0.0f, square.at<float>(y, x) - m * m)) / (m + 5));
      }
    add("local variation median", bench::quantile(variation, 0.5));
    add("local variation p90", bench::quantile(variation, 0.9));
  }

  /// Share of the power along rows above 1 and 2 cycles per mm.
  void detail(const std::string& along, const cv::Mat& image) {
    cv::Mat rows = image - mean_, spectrum;
    for (int x = 0; x < rows.cols; ++x)
      rows.col(x) *= 0.5 - 0.5 * std::cos(2 * CV_PI * x / std::max(1, rows.cols - 1));  // Hann's window
    cv::dft(rows, spectrum, cv::DFT_ROWS | cv::DFT_COMPLEX_OUTPUT);
    double all = 0, above1 = 0, above2 = 0;
    for (int y = 0; y < spectrum.rows; ++y)
      for (int x = 0; x <= spectrum.cols / 2; ++x) {
        const auto& c = spectrum.at<cv::Vec2f>(y, x);
        const double power = double(c[0]) * c[0] + double(c[1]) * c[1];
        const double perMm = x * kFeaturePixelsPer_mm / spectrum.cols;
        if (perMm > 0.1) all += power;
        if (perMm > 1) above1 += power;
        if (perMm > 2) above2 += power;
      }
    add(along + " power above 1/mm", all > 0 ? above1 / all : kUndefined);
    add(along + " power above 2/mm", all > 0 ? above2 / all : kUndefined);
  }

  void edges() {
    cv::Mat gx, gy, magnitude;
    cv::Sobel(image_, gx, CV_32F, 1, 0, 3, 1, 0, cv::BORDER_REFLECT);
    cv::Sobel(image_, gy, CV_32F, 0, 1, 3, 1, 0, cv::BORDER_REFLECT);
    cv::magnitude(gx, gy, magnitude);
    add("axial / lateral gradient", meanOf(cv::abs(gy)) / std::max(1e-6, meanOf(cv::abs(gx))));
    add("gradient / mean", meanOf(magnitude) / mean_);
    const cv::Mat off = gy - meanOf(gy), square = off.mul(off);
    const double variance = meanOf(square);
    add("gradient kurtosis", variance > 0 ? meanOf(square.mul(square)) / (variance * variance) : kUndefined);
  }

  void ridges() {
    const cv::Mat ridges = ridgesOf(image_);
    const double power = meanOf(ridges.mul(ridges));
    for (const int shift_px : {5, 10, 20, 40}) {
      const cv::Mat left = ridges.colRange(0, ridges.cols - shift_px), right = ridges.colRange(shift_px, ridges.cols);
      std::string name = "ridge correlation at " + std::to_string(shift_px / 10);
      if (shift_px == 5) name += ".5";
      add(name + " mm", power > 0 ? meanOf(left.mul(right)) / power : kUndefined);
    }
    add("ridge length, mm", ridgeLength_mm(ridges));
  }

  /// Mean width of the connected pieces among the strongest twentieth of the ridges, each piece weighted by its area,
  /// so that a line over the whole image has a large weight.
  static double ridgeLength_mm(const cv::Mat& ridges) {
    const cv::Mat strong = ridges > bench::quantile(valuesOf(ridges), 0.95);
    cv::Mat pieces, about, middles;
    const int count = cv::connectedComponentsWithStats(strong, pieces, about, middles);
    double sum = 0, area = 0;
    for (int n = 1; n < count; ++n) {
      const double pixels = about.at<int>(n, cv::CC_STAT_AREA);
      sum += pixels * about.at<int>(n, cv::CC_STAT_WIDTH), area += pixels;
    }
    return area > 0 ? sum / area / kFeaturePixelsPer_mm : kUndefined;
  }

  void depthBand(int band) {
    const std::string at =
        " at " + std::to_string(band * kBand_mm) + " to " + std::to_string((band + 1) * kBand_mm) + " mm";
    const int first = int(band * kBand_mm * kFeaturePixelsPer_mm),
              last = int((band + 1) * kBand_mm * kFeaturePixelsPer_mm);
    const bool isThere = image_.rows >= last;
    const cv::Mat rows = isThere ? image_.rowRange(first, last) : cv::Mat();
    const cv::Mat fine = isThere ? cv::Mat(rows - wide(rows)) : cv::Mat();
    add("grain axial, mm" + at, isThere ? halfWidth_mm(fine, 0, 1) : kUndefined);
    add("grain lateral, mm" + at, isThere ? halfWidth_mm(fine, 1, 0) : kUndefined);
    add("pixel noise / mean" + at, isThere ? pixelNoise(rows) / std::max(1.0, meanOf(rows)) : kUndefined);
  }

  /// Slow shading, without speckle.
  static cv::Mat wide(const cv::Mat& image) {
    cv::Mat wide;
    cv::GaussianBlur(image, wide, {0, 0}, 10, 10, cv::BORDER_REFLECT);
    return wide;
  }

  /// Full width at half height of the autocorrelation, along a row or a column.
  static double halfWidth_mm(const cv::Mat& fine, int stepX, int stepY) {
    const double power = meanOf(fine.mul(fine));
    if (power <= 0) return kUndefined;
    double before = 1;
    for (int lag = 1; lag < 60; ++lag) {
      const int dx = lag * stepX, dy = lag * stepY;
      const cv::Mat here = fine(cv::Rect(0, 0, fine.cols - dx, fine.rows - dy)),
                    there = fine(cv::Rect(dx, dy, fine.cols - dx, fine.rows - dy));
      const double now = meanOf(here.mul(there)) / power;
      if (now < 0.5) return 2 * (lag - 1 + (before - 0.5) / (before - now)) / kFeaturePixelsPer_mm;
      before = now;
    }
    return kUndefined;
  }

  /// Standard deviation of the noise between neighboring pixels, from the median of the Laplacian's magnitude
  /// (Immerkaer, Comput. Vis. Image Underst. 1996, 64:300, with the median instead of the mean, which edges would
  /// raise).
  static double pixelNoise(const cv::Mat& image) {
    const cv::Mat kernel = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
    cv::Mat differs;
    cv::filter2D(image, differs, CV_32F, kernel, {-1, -1}, 0, cv::BORDER_REFLECT);
    return bench::quantile(valuesOf(cv::abs(differs)), 0.5) / (0.6745 * 6);
  }

  cv::Mat image_, smooth_;
  double mean_;
  std::vector<AppearanceFeature> features_;
};

}  // namespace

Result<GrayImage> atFeatureScale(const GrayImage& image, double pixelsPer_mm, double depth_mm) {
  if (!(pixelsPer_mm >= 1 && pixelsPer_mm <= 100))
    return fail("The scale of an image must be 1 to 100 pixels per mm, not " + std::to_string(pixelsPer_mm) + ".");
  if (image.width < 10 * pixelsPer_mm || image.height < 10 * pixelsPer_mm)
    return fail("The image is smaller than 10 x 10 mm.");
  const double factor = kFeaturePixelsPer_mm / pixelsPer_mm;
  cv::Mat scaled;
  // Shrinking averages over the area of each new pixel, which avoids aliasing.
  cv::resize(bench::bytesOf(image), scaled, {}, factor, factor, factor < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
  return bench::pictureOf(scaled.rowRange(0, std::min(scaled.rows, int(std::lround(depth_mm * kFeaturePixelsPer_mm)))));
}

std::vector<AppearanceFeature> appearanceFeatures(const GrayImage& image) {
  return Measuring(image).features();
}

std::vector<AppearanceFeature> motionFeatures(const std::vector<GrayImage>& frames) {
  constexpr int kFar = kClipFrames / 3;
  std::vector<AppearanceFeature> features{{"motion: correlation of detail after 1/30 s", kUndefined},
                                          {"motion: correlation of detail after 1/3 s", kUndefined},
                                          {"motion: change from frame to frame / mean", kUndefined},
                                          {"motion: flicker of the mean gray", kUndefined}};
  if (frames.size() <= std::size_t(kFar)) return features;
  std::vector<cv::Mat> images, details;
  double mean = 0, square = 0, change = 0, near = 0, far = 0;
  const double count = double(frames.size());
  for (const GrayImage& frame : frames) {
    cv::Mat image;
    bench::bytesOf(frame).convertTo(image, CV_32F);
    const double gray = meanOf(image);
    mean += gray / count, square += gray * gray / count;
    details.push_back(image - blurred(image)), images.push_back(std::move(image));
  }
  if (mean <= 0) return features;
  const auto correlation = [&](std::size_t a, std::size_t b) {
    const double power = std::sqrt(meanOf(details[a].mul(details[a])) * meanOf(details[b].mul(details[b])));
    return power > 0 ? meanOf(details[a].mul(details[b])) / power : 0;
  };
  for (std::size_t n = 1; n < images.size(); ++n) {
    near += correlation(n - 1, n) / (count - 1);
    change += meanOf(cv::abs(images[n] - images[n - 1])) / (count - 1);
    if (n >= std::size_t(kFar)) far += correlation(n - kFar, n) / (count - kFar);
  }
  features[0].value = near, features[1].value = far, features[2].value = change / mean;
  features[3].value = std::sqrt(std::max(0.0, square - mean * mean)) / mean;
  return features;
}

}  // namespace insonate
