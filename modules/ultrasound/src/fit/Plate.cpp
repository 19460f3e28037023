#include "Plate.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace insonate::fit {
namespace {

constexpr double kBlur_px = 1.5;
constexpr double kSharpBlur_px = 1;  // closes the gaps of speckle, but not those between letters
constexpr int kGap_px = 15;
constexpr double kLeastGround = 0.04;   // share of all pixels within two grays of the background's level
constexpr float kLeastThreshold = 5;    // gray values above the background
constexpr double kNoises = 3.5;         // threshold relative to the noise of the background
constexpr double kLeastBody = 0.03;     // share of the image
constexpr double kCompanion = 0.12;     // parts of the image relative to its largest part
constexpr double kPlainSd = 1.0;        // grays: areas with less variation are drawn, not imaged
constexpr double kLeastTextured = 0.3;  // textured share of a part
constexpr double kPlainShare = 0.5;
constexpr double kMinimumShare = 0.3;  // share of the image on either side of a separation
constexpr int kLeastParting_px = 3;    // width of a separation
constexpr double kCrossing = 0.02;     // share of the image's height that may cross it
constexpr int kPlainWidth_px = 31;     // side of the square whose share of plain pixels decides

std::array<double, 256> histogramOf(const cv::Mat_<float>& picture) {
  std::array<double, 256> counts{};
  for (const float value : picture) counts[std::size_t(std::clamp(std::lround(value), 0L, 255L))] += 1;
  for (double& count : counts) count /= double(picture.total());
  return counts;
}

/// The darkest frequent level.
std::optional<int> groundLevel(const std::array<double, 256>& histogram) {
  const auto around = [&](int level) {
    double sum = 0;
    for (int k = std::max(0, level - 2); k <= std::min(255, level + 2); ++k) sum += histogram[std::size_t(k)];
    return sum;
  };
  for (int level = 0; level < 160; ++level) {
    if (around(level) < kLeastGround) continue;
    int peak = level;
    for (int k = level; k <= std::min(255, level + 12); ++k)
      if (histogram[std::size_t(k)] > histogram[std::size_t(peak)]) peak = k;
    return peak;
  }
  return std::nullopt;
}

/// A quadratic surface through the pixels within `tolerance` of the background, by two rounds of least squares.
cv::Mat_<float> groundOf(const cv::Mat_<float>& smooth, float level) {
  cv::Mat_<float> ground(smooth.size(), level);
  double tolerance = 10;
  for (int pass = 0; pass < 2; ++pass, tolerance = 7) {
    cv::Matx<double, 6, 6> normal = cv::Matx<double, 6, 6>::zeros();
    cv::Vec<double, 6> right = cv::Vec<double, 6>::all(0);
    const auto terms = [&](int row, int column) {
      const double u = 2.0 * column / smooth.cols - 1, v = 2.0 * row / smooth.rows - 1;
      return cv::Vec<double, 6>(1, u, v, u * u, u * v, v * v);
    };
    int used = 0;
    for (int row = 0; row < smooth.rows; row += 4)
      for (int column = 0; column < smooth.cols; column += 4) {
        const double value = smooth(row, column);
        if (std::abs(value - ground(row, column)) > tolerance) continue;
        const auto t = terms(row, column);
        for (int i = 0; i < 6; ++i) {
          right[i] += t[i] * value;
          for (int j = 0; j < 6; ++j) normal(i, j) += t[i] * t[j];
        }
        ++used;
      }
    for (int i = 0; i < 6; ++i) normal(i, i) += (i == 0 ? 1e-6 : 0.02) * used + 1e-9;
    const auto solution = normal.solve(right, cv::DECOMP_CHOLESKY);
    for (int row = 0; row < smooth.rows; ++row)
      for (int column = 0; column < smooth.cols; ++column) {
        const auto t = terms(row, column);
        double value = 0;
        for (int i = 0; i < 6; ++i) value += solution[i] * t[i];
        // Without visible background the surface is a guess: it is limited to the level.
        ground(row, column) = float(std::clamp(value, level - 15.0, level + 15.0));
      }
  }
  return ground;
}

/// Spread of the background, from its pixels below and above its level.
float noiseOf(const cv::Mat_<float>& above) {
  std::vector<float> values;
  for (const float value : above)
    if (std::abs(value) < 12) values.push_back(std::abs(value));
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return std::min(4.0F, 1.48F * *middle);
}

cv::Mat ellipse(int size) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {size, size});
}

/// Finds areas with so little variation, except for letters, that they are drawn, not imaged: panels, frames, paper.
cv::Mat_<uchar> plainAreas(const cv::Mat_<float>& gray) {
  cv::Mat_<float> mean, square;
  cv::blur(gray, mean, {5, 5});
  cv::blur(gray.mul(gray), square, {5, 5});
  const cv::Mat_<float> variance = square - mean.mul(mean);
  const cv::Mat_<uchar> plain = variance < kPlainSd * kPlainSd;
  cv::Mat_<uchar> share;
  cv::blur(plain, share, {kPlainWidth_px, kPlainWidth_px});
  return share > kPlainShare * 255;
}

/// The largest connected textured part, and others of the same kind that are large enough to belong to it.
cv::Mat_<uchar> bodyOf(const cv::Mat_<uchar>& mask, const cv::Mat_<uchar>& plain) {
  cv::Mat_<uchar> opened, closed;
  cv::morphologyEx(mask & ~plain, opened, cv::MORPH_OPEN, ellipse(7));
  cv::morphologyEx(opened, closed, cv::MORPH_CLOSE, ellipse(9));
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(closed, labels, stats, centres, 8, CV_32S);
  std::vector<int> textured(std::size_t(count), 0), pixels(std::size_t(count), 0);
  for (int row = 0; row < mask.rows; ++row)
    for (int column = 0; column < mask.cols; ++column) {
      const auto label = std::size_t(labels.at<int>(row, column));
      if (!opened(row, column)) continue;
      ++pixels[label];
      textured[label] += plain(row, column) == 0;
    }
  int largest = 0;
  const auto fits = [&](int label) {
    return textured[std::size_t(label)] > kLeastTextured * pixels[std::size_t(label)];
  };
  for (int label = 1; label < count; ++label)
    if (fits(label)) largest = std::max(largest, pixels[std::size_t(label)]);
  cv::Mat_<uchar> body(mask.size(), uchar{0});
  for (int row = 0; row < mask.rows; ++row)
    for (int column = 0; column < mask.cols; ++column) {
      const int label = labels.at<int>(row, column);
      if (label > 0 && opened(row, column) && fits(label) && pixels[std::size_t(label)] >= kCompanion * largest)
        body(row, column) = 255;
    }
  return body;
}

std::optional<Plate> plateOf(const cv::Mat_<float>& gray, bool darkOnLight) {
  Plate plate;
  plate.darkOnLight = darkOnLight;
  cv::GaussianBlur(gray, plate.smooth, {0, 0}, kBlur_px);
  const auto level = groundLevel(histogramOf(plate.smooth));
  if (!level) return std::nullopt;
  const cv::Mat_<float> ground = groundOf(plate.smooth, float(*level));
  plate.smooth -= ground;
  plate.threshold = std::max(kLeastThreshold, float(kNoises * noiseOf(plate.smooth)));
  plate.mask = plate.smooth > plate.threshold;
  plate.body = bodyOf(plate.mask, plainAreas(gray));
  cv::Mat_<float> sharp;
  cv::GaussianBlur(gray, sharp, {0, 0}, kSharpBlur_px);
  cv::dilate(cv::Mat_<uchar>(sharp - ground < plate.threshold), plate.gaps, cv::Mat::ones(kGap_px, kGap_px, CV_8U));
  plate.bodyShare = double(cv::countNonZero(plate.body)) / double(plate.body.total());
  if (plate.bodyShare < kLeastBody) return std::nullopt;
  return plate;
}

}  // namespace

std::vector<Plate> platesOf(const cv::Mat_<uchar>& gray) {
  cv::Mat_<float> picture;
  gray.convertTo(picture, CV_32F);
  std::vector<Plate> plates;
  if (auto plate = plateOf(picture, false)) plates.push_back(std::move(*plate));
  // Dark on light only if most of the image is light.
  if (cv::countNonZero(gray > 140) > 0.3 * double(gray.total()))
    if (auto plate = plateOf(255 - picture, true)) plates.push_back(std::move(*plate));
  return plates;
}

std::optional<std::array<Plate, 2>> halvesOf(const Plate& plate) {
  const int columns = plate.body.cols;
  std::vector<double> counts(std::size_t(columns), 0);
  for (int column = 0; column < columns; ++column)
    counts[std::size_t(column)] = cv::countNonZero(plate.body.col(column));
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  int from = 0, widest = 0, middle = 0;
  double left = 0;
  for (int column = 0; column < columns; ++column) {
    left += counts[std::size_t(column)];
    const bool parts = counts[std::size_t(column)] <= kCrossing * plate.body.rows && left >= kMinimumShare * all &&
                       left <= (1 - kMinimumShare) * all;
    if (!parts)
      from = column + 1;
    else if (column + 1 - from > widest)
      widest = column + 1 - from, middle = (from + column) / 2;
  }
  if (widest < kLeastParting_px) return std::nullopt;
  std::array<Plate, 2> halves;
  for (int side = 0; side < 2; ++side) {
    Plate& half = halves[std::size_t(side)];
    half = {plate.smooth.clone(), plate.threshold, plate.mask.clone(), plate.body.clone(), plate.gaps, 0,
            plate.darkOnLight};
    const cv::Range other = side == 0 ? cv::Range(middle, columns) : cv::Range(0, middle);
    half.smooth.colRange(other) = 0;
    for (cv::Mat_<uchar>* map : {&half.mask, &half.body}) map->colRange(other) = 0;
    half.bodyShare = double(cv::countNonZero(half.body)) / double(half.body.total());
  }
  return halves;
}

}  // namespace insonate::fit
