#include "vessel/BloodLevel.h"

#include <insonate/segmentation/Guide.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

void setPoints(LabelTool& tool, std::span<const Vec3> points_mm) {
  std::visit(
      [&](auto& parameters) {
        if constexpr (requires { parameters.points_mm; })
          parameters.points_mm.assign(points_mm.begin(), points_mm.end());
      },
      tool);
}

/// Corners of the block that extends this far beyond all points, along the patient's axes.
std::array<Vec3, 2> cornersAround(std::span<const Vec3> points_mm, double reach_mm) {
  std::array<Vec3, 2> corners{points_mm.front(), points_mm.front()};
  for (const Vec3& p : points_mm)
    for (int axis = 0; axis < 3; ++axis) {
      corners[0][axis] = std::min(corners[0][axis], p[axis] - reach_mm);
      corners[1][axis] = std::max(corners[1][axis], p[axis] + reach_mm);
    }
  return corners;
}

/// Median of the CT around the clicks.
int brightnessAt(const CtVolume& ct, std::span<const Vec3> clicks_mm) {
  constexpr double kReach_mm = 2;
  std::vector<double> levels;
  for (const Vec3& click_mm : clicks_mm) levels.push_back(segmentation::bloodAt(ct, click_mm, kReach_mm).blood_HU);
  std::ranges::nth_element(levels, levels.begin() + std::ptrdiff_t(levels.size() / 2));
  return static_cast<int>(std::lround(levels[levels.size() / 2]));
}

}  // namespace

Result<GuideMethod> methodFor(const GuideStep& step, std::span<const Vec3> clicks_mm, const CtVolume& ct) {
  if (step.clicks == 0) return step.ways.front();
  if (int(clicks_mm.size()) < step.minClicks)
    return fail(step.title + " needs " + std::to_string(step.minClicks) + " clicks or more. " + step.instruction);
  const Transform indexFromPatient = ct.geometry.indexFromPatient();
  for (const Vec3& click_mm : clicks_mm)
    if (const auto [i, j, k] = nearestVoxel(indexFromPatient * click_mm); !ct.geometry.contains(i, j, k))
      return fail("A click lies outside the CT. Click in the structure.");
  const int brightness_HU = brightnessAt(ct, clicks_mm);
  const auto fits = std::ranges::find_if(
      step.ways, [&](const GuideMethod& w) { return !w.clicks_HU || w.clicks_HU->contains(brightness_HU); });
  if (fits == step.ways.end())
    return fail("The clicks lie on " + std::to_string(brightness_HU) + " HU, which is outside the expected range. " +
                step.instruction);
  GuideMethod way = *fits;
  for (LabelStep& made : way.steps) {
    setPoints(made.tool, clicks_mm);
    if (way.around_mm) made.box_mm = cornersAround(clicks_mm, *way.around_mm);
  }
  return way;
}

std::vector<Vec3> clicksOf(const GuideStep& step, const Recipe& recipe) {
  for (const LabelStep& made : recipe.steps) {
    if (made.of != step.name) continue;
    const auto points_mm = std::visit(
        [](const auto& parameters) {
          if constexpr (requires { parameters.points_mm; }) return std::vector<Vec3>(parameters.points_mm);
          return std::vector<Vec3>{};
        },
        made.tool);
    if (!points_mm.empty()) return points_mm;
  }
  return {};
}

}  // namespace insonate
