#include "pointspread/Cysts.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace insonate::bench {
namespace {

constexpr double kInside = 0.7, kBesideFrom_mm = 1.5, kBesideTo_mm = 5;
constexpr int kSpeckles = 6;  ///< patterns of scatterers
constexpr int kEvery = 4;     ///< samples of a point's echo along the beam that make one here

struct Moments {
  double mean = 0, variance = 0;
};

Moments momentsOf(const std::vector<double>& values) {
  Moments m;
  for (const double v : values) m.mean += v / double(values.size());
  for (const double v : values) m.variance += (v - m.mean) * (v - m.mean) / double(values.size());
  return m;
}

/// Spectrum of the point's echo, its middle at the origin of a periodic plane.
cv::Mat kernelSpectrum(const Spread& spread, int rows, int columns) {
  cv::Mat kernel = cv::Mat::zeros(rows, columns, CV_32FC2);
  for (int x = 0; x < spread.across; ++x)
    for (int z = spread.along / 2 % kEvery; z < spread.along; z += kEvery) {
      const int row = (z - spread.along / 2) / kEvery, column = x - spread.across / 2;
      const auto& echo = spread.echo[std::size_t(x) * std::size_t(spread.along) + std::size_t(z)];
      kernel.at<cv::Vec2f>((row + rows) % rows, (column + columns) % columns) = {float(echo.real()),
                                                                                 float(echo.imag())};
    }
  cv::dft(kernel, kernel);
  return kernel;
}

}  // namespace

void CystEchoes::add(double x_mm, double z_mm, double diameter_mm, double amplitude) {
  const double radius_mm = diameter_mm / 2;
  if (std::hypot(x_mm, z_mm) <= kInside * radius_mm) inside.push_back(amplitude);
  const double off_mm = std::abs(x_mm) - radius_mm;
  if (off_mm >= kBesideFrom_mm && off_mm <= kBesideTo_mm && std::abs(z_mm) <= kInside * radius_mm)
    beside.push_back(amplitude);
}

double speckleSnr(const CystEchoes& echoes) {
  const Moments beside = momentsOf(echoes.beside);
  return beside.variance > 0 ? beside.mean / std::sqrt(beside.variance) : 0;
}

double contrastToNoise(const CystEchoes& echoes) {
  const Moments inside = momentsOf(echoes.inside), beside = momentsOf(echoes.beside);
  const double variance = inside.variance + beside.variance;
  return variance > 0 ? std::abs(beside.mean - inside.mean) / std::sqrt(variance) : 0;
}

double generalizedContrastToNoise(const CystEchoes& echoes) {
  constexpr int kBins = 200;
  if (echoes.inside.empty() || echoes.beside.empty()) return 0;
  const double top = std::max(*std::ranges::max_element(echoes.inside), *std::ranges::max_element(echoes.beside));
  if (top <= 0) return 0;
  std::vector<double> inside(kBins), beside(kBins);
  const auto fill = [&](const std::vector<double>& values, std::vector<double>& bins) {
    for (const double v : values)
      bins[std::size_t(std::min(kBins - 1.0, v / top * kBins))] += 1 / double(values.size());
  };
  fill(echoes.inside, inside), fill(echoes.beside, beside);
  double common = 0;
  for (std::size_t n = 0; n < kBins; ++n) common += std::min(inside[n], beside[n]);
  return 1 - common;
}

CystEchoes cystOf(const Spread& spread, double diameter_mm) {
  const double z_mm = spread.z_mm * kEvery;
  const double half_mm = diameter_mm / 2 + kBesideTo_mm + 2;
  const int columns = cv::getOptimalDFTSize(int(2 * half_mm / spread.x_mm)),
            rows = cv::getOptimalDFTSize(int((diameter_mm + 6) / z_mm));
  const cv::Mat kernel = kernelSpectrum(spread, rows, columns);
  CystEchoes echoes;
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  const auto xOf = [&](int column) { return (column - columns / 2) * spread.x_mm; };
  const auto zOf = [&](int row) { return (row - rows / 2) * z_mm; };
  for (int n = 0; n < kSpeckles; ++n) {
    cv::Mat tissue = cv::Mat::zeros(rows, columns, CV_32FC2);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const float real = normal(random), imaginary = normal(random);
        if (std::hypot(xOf(column), zOf(row)) > diameter_mm / 2) tissue.at<cv::Vec2f>(row, column) = {real, imaginary};
      }
    cv::Mat spectrum;
    cv::dft(tissue, spectrum);
    cv::mulSpectrums(spectrum, kernel, spectrum, 0);
    cv::idft(spectrum, tissue, cv::DFT_SCALE);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const auto& echo = tissue.at<cv::Vec2f>(row, column);
        echoes.add(xOf(column), zOf(row), diameter_mm, std::hypot(double(echo[0]), double(echo[1])));
      }
  }
  return echoes;
}

void addCyst(const EnvelopeFrame& frame, const BeamGrid& grid, Vec3 middle_mm, double diameter_mm, CystEchoes& echoes) {
  for (int sample = 0; sample < frame.samples; ++sample) {
    const double z_mm = grid.range_mm(sample) - middle_mm.z;
    if (std::abs(z_mm) > diameter_mm / 2) continue;
    for (int line = 0; line < frame.scanlines; ++line)
      echoes.add(grid.origin(line).x - middle_mm.x, z_mm, diameter_mm,
                 frame.amplitude[std::size_t(sample) * std::size_t(frame.scanlines) + std::size_t(line)]);
  }
}

void addCystFigures(const CystEchoes& small, const CystEchoes& large, PointSpreadFigures& figures) {
  figures.cnr4 = contrastToNoise(small), figures.cnr8 = contrastToNoise(large);
  figures.gcnr4 = generalizedContrastToNoise(small), figures.gcnr8 = generalizedContrastToNoise(large);
  CystEchoes both = small;
  both.beside.insert(both.beside.end(), large.beside.begin(), large.beside.end());
  figures.speckleSnr = speckleSnr(both);
}

}  // namespace insonate::bench
