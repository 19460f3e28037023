#include <insonate/bench/ImageMeasures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace insonate {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Sums for a mean and a standard deviation.
struct Moments {
  double count = 0, sum = 0, squares = 0;
  void add(double v) { ++count, sum += v, squares += v * v; }
  double mean() const { return count > 0 ? sum / count : kNaN; }
  double sd() const { return count > 0 ? std::sqrt(std::max(squares / count - mean() * mean(), 0.0)) : kNaN; }
};

template <class Use>
void overBox(const BModeImage& image, const PixelBox& box, const Use& use) {
  const int endRow = std::min(box.row + box.height, image.height);
  const int endColumn = std::min(box.column + box.width, image.width);
  for (int row = std::max(box.row, 0); row < endRow; ++row)
    for (int column = std::max(box.column, 0); column < endColumn; ++column)
      use(column, row, double(image.gray[std::size_t(row) * image.width + column]));
}

Moments momentsOf(const BModeImage& image, const PixelBox& box) {
  Moments m;
  overBox(image, box, [&](int, int, double gray) { m.add(gray); });
  return m;
}

using Quadratic = std::array<double, 6>;

Quadratic termsAt(double x, double y) {
  return {1, x, y, x * y, x * x, y * y};
}

/// Solves a symmetric positive definite system by elimination.
Quadratic solved(std::array<Quadratic, 6> a, Quadratic b) {
  for (int i = 0; i < 6; ++i)
    for (int j = i + 1; j < 6; ++j) {
      const double share = a[j][i] / a[i][i];
      for (int k = i; k < 6; ++k) a[j][k] -= share * a[i][k];
      b[j] -= share * b[i];
    }
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

/// Grey values minus the quadratic surface that fits them best, [row][column].
std::vector<double> detrended(const BModeImage& image, const PixelBox& box) {
  std::array<Quadratic, 6> normal{};
  Quadratic right{};
  const auto terms = [&](int column, int row) {
    return termsAt(2.0 * (column - box.column) / (box.width - 1) - 1, 2.0 * (row - box.row) / (box.height - 1) - 1);
  };
  overBox(image, box, [&](int column, int row, double gray) {
    const Quadratic t = terms(column, row);
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) normal[i][j] += t[i] * t[j];
      right[i] += t[i] * gray;
    }
  });
  const Quadratic fit = solved(normal, right);
  std::vector<double> rest;
  overBox(image, box, [&](int column, int row, double gray) {
    const Quadratic t = terms(column, row);
    for (int i = 0; i < 6; ++i) gray -= fit[i] * t[i];
    rest.push_back(gray);
  });
  return rest;
}

/// Full width at half height of the autocorrelation along one direction, in pixels.
double grainPixels(const std::vector<double>& values, int width, int height, bool axial) {
  const int length = axial ? height : width;
  double none = 0, before = 1;
  for (int lag = 0; lag < length / 2; ++lag) {
    const int dx = axial ? 0 : lag, dy = axial ? lag : 0;
    double sum = 0;
    for (int y = 0; y + dy < height; ++y)
      for (int x = 0; x + dx < width; ++x)
        sum += values[std::size_t(y) * width + x] * values[std::size_t(y + dy) * width + x + dx];
    sum /= double(width - dx) * (height - dy);
    if (lag == 0) none = sum;
    const double here = none > 0 ? sum / none : 1;
    if (here < 0.5) return 2 * (lag - 1 + (before - 0.5) / (before - here));
    before = here;
  }
  return kNaN;
}

double ratio(double a, double b) {
  return b > 0 ? a / b : kNaN;
}

}  // namespace

GrayStatistics grayStatistics(const BModeImage& image, const PixelBox& fieldOfView) {
  std::array<double, 256> histogram{};
  GrayStatistics shares;
  double upper = 0, count = 0, sum = 0;
  const int upperRows = static_cast<int>(0.6 * fieldOfView.height);
  overBox(image, fieldOfView, [&](int, int row, double gray) {
    ++histogram[static_cast<int>(gray)], ++count, sum += gray;
    if (row - fieldOfView.row < upperRows) ++upper, shares.blackUpper60 += gray <= 5;
  });
  shares.mean = sum / count;
  shares.blackUpper60 /= std::max(upper, 1.0);
  const auto percentile = [&](double share) {
    double below = 0;
    for (int gray = 0; gray < 256; ++gray)
      if ((below += histogram[gray]) >= share * count) return double(gray);
    return 255.0;
  };
  shares.p25 = percentile(0.25), shares.p50 = percentile(0.5), shares.p75 = percentile(0.75);
  shares.p95 = percentile(0.95), shares.p99 = percentile(0.99);
  for (int gray = 0; gray < 256; ++gray) {
    shares.black += gray <= 5 ? histogram[gray] / count : 0;
    shares.bright += gray >= 200 ? histogram[gray] / count : 0;
    shares.saturated += gray >= 250 ? histogram[gray] / count : 0;
  }
  const auto band = [&](int first, int end) {
    const int from = fieldOfView.height * first / 8, to = fieldOfView.height * end / 8;
    return momentsOf(image, {fieldOfView.column, fieldOfView.row + from, fieldOfView.width, to - from}).mean();
  };
  shares.deepOverShallow = ratio(band(6, 8), band(1, 3));
  return shares;
}

SpeckleStatistics speckleStatistics(const BModeImage& image, const PixelBox& patch) {
  const std::vector<double> rest = detrended(image, patch);
  Moments m;
  for (const double v : rest) m.add(v);
  SpeckleStatistics grain;
  grain.mean = momentsOf(image, patch).mean();
  grain.sd = m.sd();
  for (const double v : rest) grain.skewness += std::pow(v / std::max(grain.sd, 1e-9), 3) / double(rest.size());
  grain.axial_mm = grainPixels(rest, patch.width, patch.height, true) * image.pixel_mm;
  grain.lateral_mm = grainPixels(rest, patch.width, patch.height, false) * image.pixel_mm;
  return grain;
}

Lumen lumenOf(const BModeImage& image, const PixelBox& box) {
  const double w = box.width, h = box.height;
  const bool along = w > 2.5 * h;
  const auto part = [&](double x, double y, double width, double height) {
    const int left = static_cast<int>(box.column + x * w), top = static_cast<int>(box.row + y * h);
    return PixelBox{left, top, static_cast<int>(width * w), static_cast<int>(height * h)};
  };
  Moments around;
  const auto addTo = [&](Moments& m, const PixelBox& b) {
    overBox(image, b, [&](int, int, double gray) { m.add(gray); });
  };
  if (along) {
    addTo(around, part(0, -1.2, 1, 0.7));
    addTo(around, part(0, 1.5, 1, 0.7));
  } else {
    overBox(image, part(-0.75, -0.75, 2.5, 2.5), [&](int column, int row, double gray) {
      const double r = std::hypot((column - box.column - w / 2) / (w / 2), (row - box.row - h / 2) / (h / 2));
      if (r > 1.7 && r < 2.4) around.add(gray);
    });
  }
  Lumen lumen;
  const Moments inside = momentsOf(image, box);
  lumen.mean = inside.mean(), lumen.sd = inside.sd();
  lumen.overSurroundings = ratio(lumen.mean, around.mean());
  const int edge = std::min(std::max(4, box.height / 5), box.height);
  lumen.nearMinusFar = momentsOf(image, {box.column, box.row, box.width, edge}).mean() -
                       momentsOf(image, {box.column, box.row + box.height - edge, box.width, edge}).mean();
  Moments sides;
  addTo(sides, part(-1, 1.4, 0.6, 0.6));
  addTo(sides, part(1.4, 1.4, 0.6, 0.6));
  const double below = momentsOf(image, part(0, 1.4, 1, 0.6)).mean();
  lumen.belowOverSides = along || sides.count == 0 ? kNaN : below / std::max(sides.mean(), 10.0);
  return lumen;
}

double lineGray(const BModeImage& image, const PixelBox& box) {
  std::vector<double> brightest(std::max(box.width, 1), 0.0);
  overBox(image, box, [&](int column, int, double gray) {
    double& most = brightest[column - box.column];
    most = std::max(most, gray);
  });
  std::nth_element(brightest.begin(), brightest.begin() + std::ptrdiff_t(brightest.size() / 2), brightest.end());
  return brightest[brightest.size() / 2];
}

double meanGray(const BModeImage& image, const PixelBox& box) {
  return momentsOf(image, box).mean();
}

double structuralSimilarity(const BModeImage& a, const BModeImage& b) {
  constexpr int kWindow = 8, kHop = 4;
  constexpr double kC1 = (0.01 * 255) * (0.01 * 255), kC2 = (0.03 * 255) * (0.03 * 255);
  double total = 0;
  int windows = 0;
  for (int row = 0; row + kWindow <= a.height; row += kHop)
    for (int column = 0; column + kWindow <= a.width; column += kHop) {
      const PixelBox window{column, row, kWindow, kWindow};
      const Moments p = momentsOf(a, window), q = momentsOf(b, window);
      double products = 0;
      overBox(a, window, [&](int x, int y, double gray) { products += gray * b.gray[std::size_t(y) * b.width + x]; });
      const double mp = p.mean(), mq = q.mean(), covariance = products / p.count - mp * mq;
      total += (2 * mp * mq + kC1) * (2 * covariance + kC2) /
               ((mp * mp + mq * mq + kC1) * (p.sd() * p.sd() + q.sd() * q.sd() + kC2));
      ++windows;
    }
  return windows > 0 ? total / windows : 1;
}

}  // namespace insonate
