#include "StackPlan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace insonate {
namespace {

constexpr double kRadiansToDegrees = 57.29577951308232;

std::string decimals(double value, int digits) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

/// Differences of decimal strings contain rounding noise.
double tidy(double value_mm) {
  return std::round(value_mm * 1e6) / 1e6;
}

struct Spread {
  double low = 0, high = 0;
  double width() const { return high - low; }
};

/// The stack in its own frame: sorted positions along i, j and the slice normal.
struct Frame {
  Mat3 axes;
  std::vector<int> order;
  std::vector<Vec3> place_mm;  ///< relative to the first slice of the sorted stack
  std::vector<double> step_mm;
  double median_mm = 0, smallest_mm = 0, largest_mm = 0;
  double mean_mm = 0, unevenness_mm = 0;  ///< of the evenly spaced positions nearest to the slices
};

/// Least-squares line through the positions along the stack: mean_mm is its slope.
void fitLadder(Frame& f) {
  const double middle = (static_cast<double>(f.place_mm.size()) - 1) / 2;
  double meanPlace = 0, covariance = 0, variance = 0;
  for (Vec3 p : f.place_mm) meanPlace += p.z / static_cast<double>(f.place_mm.size());
  for (std::size_t n = 0; n < f.place_mm.size(); ++n) {
    const double step = static_cast<double>(n) - middle;
    covariance += step * (f.place_mm[n].z - meanPlace);
    variance += step * step;
  }
  f.mean_mm = covariance / variance;
  for (std::size_t n = 0; n < f.place_mm.size(); ++n) {
    const double ladder_mm = meanPlace + (static_cast<double>(n) - middle) * f.mean_mm;
    f.unevenness_mm = std::max(f.unevenness_mm, std::abs(f.place_mm[n].z - ladder_mm));
  }
}

Frame frameOf(const SliceStack& stack) {
  Frame f;
  const Vec3 i = normalized(stack.direction[0]);
  const Vec3 j = normalized(stack.direction[1] - dot(stack.direction[1], i) * i);
  f.axes = {{i, j, cross(i, j)}};
  f.order.resize(stack.positions_mm.size());
  std::iota(f.order.begin(), f.order.end(), 0);
  const auto along = [&](int slice) { return dot(stack.positions_mm[slice], f.axes.column[2]); };
  std::ranges::stable_sort(f.order, {}, along);
  const Vec3 first = stack.positions_mm[f.order.front()];
  for (int slice : f.order) f.place_mm.push_back(transposed(f.axes) * (stack.positions_mm[slice] - first));
  for (std::size_t n = 1; n < f.place_mm.size(); ++n) f.step_mm.push_back(f.place_mm[n].z - f.place_mm[n - 1].z);
  if (f.step_mm.empty()) return f;
  std::vector<double> sorted = f.step_mm;
  std::ranges::sort(sorted);
  f.smallest_mm = sorted.front();
  f.largest_mm = sorted.back();
  f.median_mm = sorted[(sorted.size() - 1) / 2];
  fitLadder(f);
  return f;
}

/// Positions rounded to a tenth of a millimeter count as even; a deviation of a twentieth of the spacing is invisible.
bool isEven(const Frame& f) {
  return f.unevenness_mm <= std::max(0.06, 0.05 * f.mean_mm);
}

Spread spreadOf(const Frame& f, int axis) {
  Spread s;
  for (Vec3 p : f.place_mm) s = {std::min(s.low, p[axis]), std::max(s.high, p[axis])};
  return s;
}

/// Largest distance of a slice from the line through the first and the last slice, perpendicular to the stack.
double jitterOf(const Frame& f) {
  const Vec3 last = f.place_mm.back();
  double jitter_mm = 0;
  for (Vec3 p : f.place_mm) {
    const double share = last.z > 0 ? p.z / last.z : 0;
    jitter_mm = std::max(jitter_mm, std::hypot(p.x - share * last.x, p.y - share * last.y));
  }
  return jitter_mm;
}

/// Names gaps of whole slices; returns false if the steps are not multiples of a spacing.
bool describeGaps(const Frame& f, double first_mm, std::string& where, int& missing) {
  missing = 0;
  constexpr int kNamed = 6;
  for (std::size_t n = 0; n < f.step_mm.size(); ++n) {
    const double multiple = std::round(f.step_mm[n] / f.median_mm);
    if (multiple < 1 || multiple > 1000 || std::abs(f.step_mm[n] - multiple * f.median_mm) > 0.2 * f.median_mm)
      return false;
    for (int m = 1; m < static_cast<int>(multiple); ++m, ++missing)
      if (missing < kNamed)
        where += (where.empty() ? "" : ", ") + decimals(first_mm + f.place_mm[n].z + m * f.median_mm, 1);
  }
  if (missing > kNamed) where += ", ...";
  return missing > 0;
}

void planSpacing(const SliceStack& stack, const Frame& f, StackPlan& plan) {
  plan.grid.size[2] = static_cast<int>(f.place_mm.size());
  if (f.step_mm.empty()) {
    plan.grid.spacing_mm.z = stack.thickness_mm > 0 ? stack.thickness_mm : 1;
    plan.warnings.push_back("There is only one slice; its thickness is taken as " +
                            decimals(plan.grid.spacing_mm.z, 2) + " mm.");
    return;
  }
  plan.grid.spacing_mm.z = tidy(f.mean_mm);
  if (isEven(f)) return;

  const double first_mm = dot(stack.positions_mm[f.order.front()], f.axes.column[2]);
  std::string where;
  int missing = 0;
  const bool gaps = describeGaps(f, first_mm, where, missing);
  const std::string what =
      gaps ? std::to_string(missing) + (missing == 1 ? " slice is" : " slices are") + " missing, at " + where +
                 " mm along the stack"
           : "The slices are " + decimals(f.smallest_mm, 2) + " to " + decimals(f.largest_mm, 2) + " mm apart";
  if (f.largest_mm > kLargestFilledGap_mm + kSamePlace_mm) {
    plan.refusal = what + "; the largest gap is " + decimals(f.largest_mm, 1) +
                   " mm, too much to interpolate. Export the complete series again.";
    return;
  }
  plan.resample = true;
  const double spacing_mm = tidy(gaps ? f.median_mm : f.smallest_mm);
  const double steps = f.place_mm.back().z / spacing_mm;
  if (steps > 5000) {
    plan.refusal = what + "; an even grid would need over 5000 slices. Export the series evenly spaced.";
    return;
  }
  plan.grid.spacing_mm.z = spacing_mm;
  plan.grid.size[2] = static_cast<int>(std::floor(steps + 0.1)) + 1;
  plan.warnings.push_back(what + "; the volume was interpolated to an even spacing of " + decimals(spacing_mm, 3) +
                          " mm.");
}

void planShear(const SliceStack& stack, const Frame& f, StackPlan& plan) {
  const Spread across = spreadOf(f, 0), down = spreadOf(f, 1);
  const double tolerance_mm = 0.1 * std::min(stack.spacing_mm[0], stack.spacing_mm[1]);
  if (std::max(across.width(), down.width()) <= tolerance_mm) return;
  plan.resample = true;
  const Vec3 last = f.place_mm.back();
  const double shift_mm = std::hypot(last.x, last.y);
  const double jitter_mm = jitterOf(f);
  if (shift_mm > tolerance_mm)
    plan.warnings.push_back(
        "The slices are tilted by " + decimals(std::atan2(shift_mm, last.z) * kRadiansToDegrees, 1) +
        " degrees relative to the direction of the stack (gantry tilt). They were resampled onto an orthogonal grid.");
  if (jitter_mm > tolerance_mm)
    plan.warnings.push_back("The slices are displaced sideways by up to " + decimals(jitter_mm, 1) +
                            " mm; each was put where its header says.");
  plan.grid.origin_mm = plan.grid.origin_mm + across.low * f.axes.column[0] + down.low * f.axes.column[1];
  plan.grid.size[0] += static_cast<int>(std::ceil(across.width() / stack.spacing_mm[0] - 1e-6));
  plan.grid.size[1] += static_cast<int>(std::ceil(down.width() / stack.spacing_mm[1] - 1e-6));
}

}  // namespace

bool isRegular(const SliceStack& stack) {
  const Frame f = frameOf(stack);
  return f.step_mm.empty() || (f.smallest_mm > kSamePlace_mm && isEven(f));
}

bool isRun(const SliceStack& stack) {
  const Frame f = frameOf(stack);
  if (f.step_mm.empty()) return true;
  if (f.smallest_mm <= kSamePlace_mm || f.largest_mm > kLargestFilledGap_mm + kSamePlace_mm ||
      jitterOf(f) > 0.5 * std::min(stack.spacing_mm[0], stack.spacing_mm[1]))
    return false;
  constexpr int kSlicesForOneGap = 10;
  std::string where;
  int missing = 0;
  return isEven(f) || (describeGaps(f, 0, where, missing) &&
                       missing * kSlicesForOneGap <= static_cast<int>(stack.positions_mm.size()));
}

StackPlan planStack(const SliceStack& stack) {
  StackPlan plan;
  const double skew = dot(normalized(stack.direction[0]), normalized(stack.direction[1]));
  if (!(std::abs(skew) < 0.02)) {
    plan.refusal = "The rows and columns of its slices are not at right angles. Export the original slices.";
    return plan;
  }
  const Frame f = frameOf(stack);
  plan.order = f.order;
  plan.grid.size = {stack.columns, stack.rows, 1};
  plan.grid.spacing_mm = {stack.spacing_mm[0], stack.spacing_mm[1], 1};
  plan.grid.direction = f.axes;
  plan.grid.origin_mm = stack.positions_mm[f.order.front()];
  planSpacing(stack, f, plan);
  if (!plan.refusal.empty()) return plan;
  planShear(stack, f, plan);
  const Vec3 shift = transposed(f.axes) * (plan.grid.origin_mm - stack.positions_mm[f.order.front()]);
  for (Vec3 p : f.place_mm) plan.offset_mm.push_back(p - shift);
  if (auto ok = validate(plan.grid); !ok) plan.refusal = ok.error().message;
  return plan;
}

}  // namespace insonate
