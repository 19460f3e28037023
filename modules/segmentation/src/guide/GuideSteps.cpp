#include "vessel/BloodLevel.h"

#include <insonate/segmentation/Guide.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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

/// The first method that fits the tissue at the clicks; null if there is none.
const GuideMethod* fittingMethod(const GuideStep& step, int brightness_HU) {
  const auto fits = std::ranges::find_if(
      step.ways, [&](const GuideMethod& w) { return !w.clicks_HU || w.clicks_HU->contains(brightness_HU); });
  return fits == step.ways.end() ? nullptr : &*fits;
}

std::string tooFewClicks(const GuideStep& step, int needed) {
  return step.title + " needs " + std::to_string(needed) + " clicks or more" +
         (needed > step.minClicks ? ", since the CT shows no contrast agent there" : "") + ". " + step.instruction;
}

}  // namespace

int clicksNeeded(const GuideStep& step, std::span<const Vec3> clicks_mm, const CtVolume& ct) {
  const Transform indexFromPatient = ct.geometry.indexFromPatient();
  std::vector<Vec3> inside_mm;
  std::ranges::copy_if(clicks_mm, std::back_inserter(inside_mm), [&](const Vec3& click_mm) {
    const auto [i, j, k] = nearestVoxel(indexFromPatient * click_mm);
    return ct.geometry.contains(i, j, k);
  });
  if (inside_mm.empty()) return step.minClicks;
  const GuideMethod* way = fittingMethod(step, brightnessAt(ct, inside_mm));
  return way ? std::max(step.minClicks, way->minClicks) : step.minClicks;
}

Result<GuideMethod> methodFor(const GuideStep& step, std::span<const Vec3> clicks_mm, const CtVolume& ct) {
  if (step.clicks == 0) return step.ways.front();
  if (int(clicks_mm.size()) < step.minClicks) return fail(tooFewClicks(step, step.minClicks));
  const Transform indexFromPatient = ct.geometry.indexFromPatient();
  for (const Vec3& click_mm : clicks_mm)
    if (const auto [i, j, k] = nearestVoxel(indexFromPatient * click_mm); !ct.geometry.contains(i, j, k))
      return fail("A click lies outside the CT. Click in the structure.");
  const int brightness_HU = brightnessAt(ct, clicks_mm);
  const GuideMethod* fits = fittingMethod(step, brightness_HU);
  if (!fits)
    return fail("The clicks lie on " + std::to_string(brightness_HU) + " HU, which is outside the expected range. " +
                step.instruction);
  if (int(clicks_mm.size()) < fits->minClicks) return fail(tooFewClicks(step, fits->minClicks));
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
