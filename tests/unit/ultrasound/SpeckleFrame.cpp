#include "SpeckleFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>

namespace insonate::test {
namespace {

using Field = std::vector<std::complex<float>>;

std::vector<float> gaussian(double fwhm) {
  const double sd = fwhm / 2.3548;
  const int radius = static_cast<int>(std::ceil(3.5 * sd));
  std::vector<float> kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sd * sd))));
  return kernel;
}

/// Periodic convolution along the rows (stride 1) or the columns.
Field convolved(const Field& in, int columns, int rows, const std::vector<float>& kernel, bool alongRows) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  Field out(in.size());
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      std::complex<float> sum = 0;
      for (int o = -radius; o <= radius; ++o) {
        const int row = alongRows ? r : (r + o + rows) % rows, column = alongRows ? (c + o + columns) % columns : c;
        sum += kernel[o + radius] * in[std::size_t(row) * columns + column];
      }
      out[std::size_t(r) * columns + c] = sum;
    }
  return out;
}

/// Takes the best fitting quadratic surface off (Gram-Schmidt on 1, x, y, xy, x^2, y^2).
void detrend(std::vector<double>& patch, int size) {
  std::vector<std::vector<double>> basis;
  for (int term = 0; term < 6; ++term) {
    std::vector<double> f(patch.size());
    for (int r = 0; r < size; ++r)
      for (int c = 0; c < size; ++c) {
        const double x = 2.0 * c / size - 1, y = 2.0 * r / size - 1;
        f[std::size_t(r) * size + c] = std::array{1.0, x, y, x * y, x * x, y * y}[term];
      }
    const auto product = [&](const std::vector<double>& a, const std::vector<double>& b) {
      double sum = 0;
      for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
      return sum;
    };
    const auto subtract = [&](std::vector<double>& from, const std::vector<double>& unit) {
      const double share = product(from, unit);
      for (std::size_t i = 0; i < from.size(); ++i) from[i] -= share * unit[i];
    };
    for (const auto& unit : basis) subtract(f, unit);
    const double length = std::sqrt(product(f, f));
    for (double& v : f) v /= length;
    subtract(patch, f);
    basis.push_back(f);
  }
}

double fwhm(const std::vector<double>& patch, int size, bool axial) {
  double last = 0, zero = 0;
  for (int lag = 0; lag < size / 2; ++lag) {
    double sum = 0;
    for (int a = 0; a + lag < size; ++a)
      for (int b = 0; b < size; ++b)
        sum += axial ? patch[std::size_t(a) * size + b] * patch[std::size_t(a + lag) * size + b]
                     : patch[std::size_t(b) * size + a] * patch[std::size_t(b) * size + a + lag];
    sum /= double(size - lag) * size;
    if (lag == 0) zero = sum;
    if (sum < 0.5 * zero) return 2 * (lag - 1 + (last - 0.5 * zero) / (last - sum));
    last = sum;
  }
  return std::nan("");
}

}  // namespace

EnvelopeFrame speckleFrame(int scanlines, int samples, int looks, double axialFwhm, double lateralFwhm, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  EnvelopeFrame frame;
  frame.resize(scanlines, samples, looks);
  for (int look = 0; look < looks; ++look) {
    Field field(std::size_t(scanlines) * samples);
    for (auto& value : field) value = {normal(random), normal(random)};
    field = convolved(field, scanlines, samples, gaussian(axialFwhm), false);
    field = convolved(field, scanlines, samples, gaussian(lateralFwhm), true);
    double power = 0;
    for (const auto& value : field) power += std::norm(value);
    const float scale = static_cast<float>(1 / std::sqrt(power / double(field.size())));
    std::transform(field.begin(), field.end(), frame.look(look), [=](auto value) { return scale * std::abs(value); });
  }
  return frame;
}

Grain grainOf(const BModeImage& image, int column, int row, int size) {
  std::vector<double> patch;
  for (int r = 0; r < size; ++r)
    for (int c = 0; c < size; ++c) patch.push_back(image.gray[std::size_t(row + r) * image.width + column + c]);
  Grain grain{};
  for (const double v : patch) grain.mean += v / double(patch.size());
  detrend(patch, size);
  double second = 0, third = 0;
  for (const double v : patch) second += v * v, third += v * v * v;
  grain.sd = std::sqrt(second / double(patch.size()));
  grain.skewness = third / double(patch.size()) / std::pow(grain.sd, 3);
  grain.axialFwhm_mm = fwhm(patch, size, true) * image.pixel_mm;
  grain.lateralFwhm_mm = fwhm(patch, size, false) * image.pixel_mm;
  return grain;
}

Grain medianGrain(const BModeImage& image, int patch) {
  std::vector<Grain> all;
  for (int row = image.height / 8; row + patch < image.height * 7 / 8; row += patch)
    for (int column = image.width / 4; column + patch < image.width * 3 / 4; column += patch)
      all.push_back(grainOf(image, column, row, patch));
  const auto median = [&](double Grain::*member) {
    std::vector<double> values;
    for (const Grain& grain : all) values.push_back(grain.*member);
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
  };
  return {median(&Grain::mean), median(&Grain::sd), median(&Grain::skewness), median(&Grain::axialFwhm_mm),
          median(&Grain::lateralFwhm_mm)};
}

}  // namespace insonate::test
