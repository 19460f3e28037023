#include "OutlineFit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace insonate::segmentation {
namespace {

/// Between neighboring rays the wall moves at most by this share of its radius, or by this number of steps. A step
/// costs less in a wider vessel, so that the outline of a flat vein costs the same on any scale.
constexpr double kMaxBend = 0.25, kBend = 0.4;
constexpr int kMinBend = 3, kBendRadius = 12;
/// Number of standard deviations of the blur within which the CT changes to the next tissue behind the wall. A change
/// below this share of the contrast does not count, and noise reverses the change by at most the other share.
constexpr double kEdge = 2, kMinChange = 0.3, kNoise = 0.1;
constexpr double kFullWidth = 2.355;  // at half maximum, of a Gaussian, by its standard deviation
constexpr int kAveraged = 2;          // sections on both sides
constexpr double kScanner_mm = 0.4;   // standard deviation of a CT scanner's blur, which is 0.9 mm in full width at
                                      // half maximum

/// Position between samples at which a profile passes a value, searched from `from` on; negative if it does not.
double crossing(const std::vector<double>& profile, int from, int to, double value) {
  for (int n = from; n < to; ++n)
    if ((profile[n] - value) * (profile[n + 1] - value) <= 0 && profile[n] != profile[n + 1])
      return n + (profile[n] - value) / (profile[n] - profile[n + 1]);
  return -1;
}

}  // namespace

/// A voxel is a mean over its width, with a variance of 1/12 of its square; linear interpolation adds 1/6 on average.
OutlineFit::OutlineFit(const CtVolume& ct, double largest_mm)
    : ct_(ct),
      indexFromPatient_(ct.geometry.indexFromPatient()),
      steps_(static_cast<int>(largest_mm / kStep_mm)),
      blur_mm2_(kScanner_mm * kScanner_mm + dot(ct.geometry.spacing_mm, ct.geometry.spacing_mm) / 12),
      reach_(static_cast<int>(std::ceil(kEdge * std::sqrt(blur_mm2_) / kStep_mm))) {}

std::vector<double> OutlineFit::profile(const std::vector<VesselOutline>& sections, int n,
                                        std::pair<double, double> step, double first, int samples) const {
  const int from = std::max(0, n - kAveraged), to = std::min(int(sections.size()) - 1, n + kAveraged);
  std::vector<double> values(samples);
  for (int m = from; m <= to; ++m) {
    const Vec3 center = indexFromPatient_ * sections[m].center_mm;
    const Vec3 along = indexFromPatient_.linear * (sections[m].right * step.first + sections[m].down * step.second);
    for (int at = 0; at < samples; ++at)
      values[at] += sampleLinear(ct_, center + along * (first + at)) / (to - from + 1);
  }
  return values;
}

double OutlineFit::bloodIn(const VesselOutline& section, const SectionShape& shape) const {
  std::vector<double> hu;
  for (int ray = 0; ray < VesselOutline::kRays; ++ray) {
    const auto [x, y] = shape.along(ray);
    const Vec3 wall_mm = (section.right * x + section.down * y) * section.radius_mm[ray];
    for (const double share : {0.2, 0.35, 0.5})
      hu.push_back(sampleLinear(ct_, indexFromPatient_ * (section.center_mm + wall_mm * share)));
  }
  const auto middle = hu.begin() + std::ptrdiff_t(hu.size() / 2);
  std::ranges::nth_element(hu, middle);
  return *middle;
}

/// Distance by which blur moves both sides of a layer (a stent, a plaque, the layer between two vessels) toward each
/// other, if the layer has this width at half its height: widths add as squares.
double OutlineFit::widening_mm(double seen_mm) const {
  const double blur_mm = kFullWidth * std::sqrt(blur_mm2_);
  return (seen_mm - std::sqrt(std::max(0.0, seen_mm * seen_mm - blur_mm * blur_mm))) / 2;
}

/// Blur moves the half-value line of a round vessel inward, by the heat equation d r / d variance = -1 / (2 r). In a
/// thin vessel it reduces the value in the middle by exp(-r^2 / (2 variance)), which moves the line outward by half of
/// that over the slope of the edge, 1 / sqrt(2 pi variance).
Radii OutlineFit::refined(const std::vector<VesselOutline>& sections, int n, const SectionShape& shape,
                          const BloodLevel& level) const {
  const double contrast_HU = 2 * (level.blood_HU - level.half_HU);
  const double min_HU = kMinChange * contrast_HU, noise_HU = kNoise * contrast_HU;
  Radii radii = sections[n].radius_mm;
  for (int ray = 0; ray < VesselOutline::kRays; ++ray) {
    const auto [x, y] = shape.along(ray);
    const double stretch = std::hypot(x, y);
    double radius_mm = radii[ray] * stretch;
    const int wall = static_cast<int>(std::lround(radius_mm / kStep_mm));
    const int inner = std::max(0, wall - reach_), outer = wall + reach_;
    const std::vector<double> hu =
        profile(sections, n, {x / stretch * kStep_mm, y / stretch * kStep_mm}, 0, outer + reach_ + 1);
    // The tissue behind the wall: the place where the CT stops to change, except for noise.
    const double way = hu[std::min(wall + 1, outer)] < level.blood_HU ? -1 : 1;
    int behind = wall;
    for (int at = wall + 1; at <= outer && way * (hu[behind] - hu[at]) < noise_HU; ++at)
      if (way * hu[at] > way * hu[behind]) behind = at;
    if (std::abs(hu[behind] - level.blood_HU) < min_HU) continue;
    const double half_HU = (level.blood_HU + hu[behind]) / 2;
    const double found = crossing(hu, inner, behind, half_HU);
    if (found < 0) continue;
    radius_mm = found * kStep_mm;
    if (const double far = crossing(hu, behind, int(hu.size()) - 1, half_HU); far > 0)
      radius_mm += widening_mm((far - found) * kStep_mm);
    const double true_mm = std::max(radius_mm, std::sqrt(blur_mm2_));
    radius_mm += blur_mm2_ / (2 * true_mm) -
                 std::sqrt(std::numbers::pi / 2 * blur_mm2_) * std::exp(-true_mm * true_mm / (2 * blur_mm2_));
    radii[ray] = radius_mm / stretch;
  }
  return radii;
}

/// Along each ray, the inside of the wall should have the level of blood: minimizes the sum of (unlikeness - 1) up to
/// the wall.
Radii OutlineFit::fitted(const std::vector<VesselOutline>& sections, int n, const SectionShape& shape,
                         const BloodLevel& level, const Radii* expected) const {
  RadialCost wall(steps_, kStep_mm);
  for (int ray = 0; ray < VesselOutline::kRays; ++ray) {
    const auto [x, y] = shape.along(ray);
    const double stretch = std::hypot(x, y);
    // Wall r is behind sample r.
    const std::vector<double> hu = profile(sections, n, {x * kStep_mm, y * kStep_mm}, 0.5, steps_);
    double sum = 0;
    for (int r = 0; r < steps_; ++r) {
      sum += (level.unlikeness(hu[r]) - 1) * stretch;
      wall.at(ray, r) = sum;
    }
  }
  const auto bendAt = [](int r) {
    return Bend{std::max(kMinBend, static_cast<int>(kMaxBend * r)), kBend * kBendRadius / std::max(r, kBendRadius)};
  };
  return closedWay(std::move(wall), bendAt, expected);
}

}  // namespace insonate::segmentation
