#include "Evidence.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace insonate::fit {
namespace {

constexpr double kSampleStep_px = 3;
constexpr double kProbe_px = 0.5;
constexpr double kPlateau_px = 5;  // distance inside a step at which its height is read
constexpr int kRounds = 4, kIterations = 6;

std::optional<float> valueAt(const Plate& plate, double x, double y) {
  const int column = int(std::floor(x)), row = int(std::floor(y));
  if (column < 0 || row < 0 || column + 1 >= plate.smooth.cols || row + 1 >= plate.smooth.rows) return std::nullopt;
  const float fx = float(x - column), fy = float(y - row);
  const auto& s = plate.smooth;
  return (1 - fy) * ((1 - fx) * s(row, column) + fx * s(row, column + 1)) +
         fy * ((1 - fx) * s(row + 1, column) + fx * s(row + 1, column + 1));
}

/// The first step up from the background, coming from outside: its distance outside the sample. None if there is no
/// background outside or no light inside.
std::optional<double> stepNear(const EdgeSample& sample, const Plate& plate, double reach) {
  const auto value = [&](double by) {
    return valueAt(plate, sample.at.x + by * sample.outward.x, sample.at.y + by * sample.outward.y);
  };
  for (double by = reach; by >= -reach; by -= kProbe_px) {
    const auto here = value(by);
    if (!here) return std::nullopt;
    if (*here <= plate.threshold) continue;
    if (by == reach) return std::nullopt;
    // The blur widens a bright edge: its place is where half its height is reached.
    float height = *here;
    for (double in = by; in >= by - kPlateau_px; in -= kProbe_px) height = std::max(height, value(in).value_or(0));
    const float half = std::max(plate.threshold, height / 2);
    float before = value(by + kProbe_px).value_or(0);
    for (double in = by; in >= by - kPlateau_px; in -= kProbe_px) {
      const float now = value(in).value_or(before);
      if (now >= half) return in + kProbe_px * (now > before ? (now - half) / (now - before) : 0.0F);
      before = now;
    }
    return by;
  }
  return std::nullopt;
}

struct Step {
  PixelPoint at;
  Edge edge;
};

std::vector<Step> stepsNear(const FovModel& model, const Plate& plate, double reach) {
  std::vector<Step> steps;
  for (const EdgeSample& sample : edgeSamples(model, kSampleStep_px))
    if (const auto by = stepNear(sample, plate, reach))
      steps.push_back({{sample.at.x + *by * sample.outward.x, sample.at.y + *by * sample.outward.y}, sample.edge});
  return steps;
}

/// Tukey's weight; hypoechoic tissue at the border causes steps inside of it, so that those have less weight.
double weightOf(double residual, double width) {
  const double r = residual / (residual < 0 ? 0.6 * width : width);
  if (std::abs(r) >= 1) return 0;
  const double k = 1 - r * r;
  return k * k;
}

bool sane(const FovModel& model) {
  const bool finite = std::isfinite(model.x + model.y + model.turn + model.half + model.inner + model.outer);
  return finite && model.outer > model.inner + 10 && model.half > (model.fan ? 0.05 : 5) &&
         model.half < (model.fan ? 1.4 : 1e5) && std::abs(model.turn) < 0.5;
}

/// One step of damped Gauss-Newton; the unchanged model if it cannot be improved.
FovModel oneStep(const FovModel& model, const std::vector<Step>& steps, double width) {
  const int n = parameters(model);
  cv::Matx<double, 6, 6> normal = cv::Matx<double, 6, 6>::zeros();
  cv::Vec<double, 6> right = cv::Vec<double, 6>::all(0);
  std::array<FovModel, 6> nudged;
  std::array<double, 6> by{};
  for (int i = 0; i < n; ++i) {
    by[i] = (i == 2 || (i == 3 && model.fan)) ? 1e-4 : 1e-2;
    nudged[i] = model;
    parameter(nudged[i], i) += by[i];
  }
  const Beyond beyond(model);
  for (const Step& step : steps) {
    const double residual = beyond(step.at)[step.edge], weight = weightOf(residual, width);
    if (weight == 0) continue;
    std::array<double, 6> slope{};
    for (int i = 0; i < n; ++i) slope[i] = (nudged[i].beyond(step.at)[step.edge] - residual) / by[i];
    for (int i = 0; i < n; ++i) {
      right[i] -= weight * slope[i] * residual;
      for (int j = 0; j < n; ++j) normal(i, j) += weight * slope[i] * slope[j];
    }
  }
  for (int i = 0; i < 6; ++i) {
    const double scale = (i == 2 || (i == 3 && model.fan)) ? model.outer * model.outer / 4 : 1;
    normal(i, i) += 0.05 * scale + 1e-3 * normal(i, i);
  }
  const auto change = normal.solve(right, cv::DECOMP_CHOLESKY);
  FovModel moved = model;
  for (int i = 0; i < n; ++i) parameter(moved, i) += change[i];
  moved.inner = std::max(0.0, moved.inner);
  return sane(moved) ? moved : model;
}

}  // namespace

FovModel refined(const FovModel& model, const Plate& plate, double reach_px) {
  FovModel best = model;
  double reach = reach_px;
  for (int round = 0; round < kRounds; ++round, reach = std::max(4.0, reach / 1.7)) {
    const std::vector<Step> steps = stepsNear(best, plate, reach);
    if (steps.size() < 12) return best;
    for (int k = 0; k < kIterations; ++k) best = oneStep(best, steps, std::max(3.0, 0.6 * reach));
  }
  return best;
}

}  // namespace insonate::fit
