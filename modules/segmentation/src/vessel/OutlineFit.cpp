#include "OutlineFit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace insonate::segmentation {
namespace {

constexpr int kRays = VesselOutline::kRays;
/// From a ray to the next, the wall moves by no more than this share of its radius, or so many steps; what a step
/// costs, less where the vessel is wider, so that the outline of a flat vein is as cheap on any scale.
constexpr double kMostBend = 0.25, kBend = 0.4;
constexpr int kLeastBend = 3, kBendRadius = 12;
/// Behind the wall the CT falls or rises to the next tissue within so many standard deviations of the blur; less of a
/// change than this share of the contrast is none, and noise turns the way back by no more than that one.
constexpr double kEdge = 2, kLeastChange = 0.3, kNoise = 0.1;
constexpr double kScanner_mm = 0.4;  // standard deviation of a CT scanner's blur, 0.9 mm in full width at half maximum

/// Between samples of a profile, where it passes a value on its way from `from` on; negative where it does not.
double crossing(const std::vector<double>& profile, int from, int to, double value) {
  for (int n = from; n < to; ++n)
    if ((profile[n] - value) * (profile[n + 1] - value) <= 0 && profile[n] != profile[n + 1])
      return n + (profile[n] - value) / (profile[n] - profile[n + 1]);
  return -1;
}

}  // namespace

/// A voxel is a mean over its width, with a variance of 1/12 of its square; linear interpolation adds 1/6 on average.
OutlineFit::OutlineFit(const CtVolume& blurred, double smoothing_mm, double largest_mm)
    : ct_(blurred),
      indexFromPatient_(blurred.geometry.indexFromPatient()),
      steps_(static_cast<int>(largest_mm / kStep_mm)),
      blur_mm2_(kScanner_mm * kScanner_mm + smoothing_mm * smoothing_mm +
                dot(blurred.geometry.spacing_mm, blurred.geometry.spacing_mm) / 12) {}

Vec3 OutlineFit::stepAlong(const VesselOutline& outline, int ray) const {
  const double angle = 2 * std::numbers::pi * ray / kRays;
  return indexFromPatient_.linear * (outline.right * std::cos(angle) + outline.down * std::sin(angle)) * kStep_mm;
}

std::vector<double> OutlineFit::profile(const VesselOutline& outline, int ray, int samples) const {
  const Vec3 centre = indexFromPatient_ * outline.centre_mm, step = stepAlong(outline, ray);
  std::vector<double> values(samples);
  for (int n = 0; n < samples; ++n) values[n] = sampleLinear(ct_, centre + step * n);
  return values;
}

/// Blur moves the half-way line of a round vessel inward: by the heat equation, d r / d variance = -1 / (2 r).
void OutlineFit::refine(VesselOutline& outline, const BloodLevel& level) const {
  const int reach = static_cast<int>(std::ceil(kEdge * std::sqrt(blur_mm2_) / kStep_mm));
  const double contrast_HU = 2 * (level.blood_HU - level.half_HU);
  const double least_HU = kLeastChange * contrast_HU, noise_HU = kNoise * contrast_HU;
  for (int ray = 0; ray < kRays; ++ray) {
    double& radius_mm = outline.radius_mm[ray];
    const int wall = static_cast<int>(std::lround(radius_mm / kStep_mm));
    const int inner = std::max(0, wall - reach), outer = wall + reach;
    const std::vector<double> hu = profile(outline, ray, outer + 1);
    // The tissue behind the wall: where the CT stops to fall, or to rise, but for noise.
    const double way = hu[std::min(wall + 1, outer)] < level.blood_HU ? -1 : 1;
    int behind = wall;
    for (int n = wall + 1; n <= outer && way * (hu[behind] - hu[n]) < noise_HU; ++n)
      if (way * hu[n] > way * hu[behind]) behind = n;
    if (std::abs(hu[behind] - level.blood_HU) < least_HU) continue;
    const double found = crossing(hu, inner, behind, (level.blood_HU + hu[behind]) / 2);
    if (found < 0) continue;
    radius_mm = found * kStep_mm;
    radius_mm += blur_mm2_ / (2 * std::max(radius_mm, std::sqrt(blur_mm2_)));
  }
}

/// Along each ray, what lies inside the wall should look like blood: the sum of unlikeness - 1 up to the wall is
/// smallest.
void OutlineFit::fit(VesselOutline& outline, const BloodLevel& level, const Radii* expected) const {
  RadialCost wall(steps_, kStep_mm);
  const Vec3 centre = indexFromPatient_ * outline.centre_mm;
  for (int n = 0; n < kRays; ++n) {
    const Vec3 step = stepAlong(outline, n);
    double sum = 0;
    for (int r = 0; r < steps_; ++r) {
      // Wall r lies behind sample r.
      sum += level.unlikeness(sampleLinear(ct_, centre + step * (r + 0.5))) - 1;
      wall.at(n, r) = sum;
    }
  }
  const auto bendAt = [](int r) {
    return Bend{std::max(kLeastBend, static_cast<int>(kMostBend * r)), kBend * kBendRadius / std::max(r, kBendRadius)};
  };
  outline.radius_mm = closedWay(std::move(wall), bendAt, expected);
}

}  // namespace insonate::segmentation
