#include "BloodLevel.h"

#include <insonate/segmentation/Brush.h>

#include <algorithm>
#include <array>
#include <vector>

namespace insonate::segmentation {
namespace {

constexpr double kBlood_mm = 1.2;     // the ball whose median is the blood's
constexpr int kTissueFrom_HU = -120;  // air and lung say nothing about where blood ends
constexpr int kTissueBelowBlood_HU = 30;
constexpr double kUsualTissue_HU = 50;  // muscle, where nothing darker than blood is near
constexpr double kLimit = 0.6;          // of the way to half
constexpr double kMost = 4;

std::vector<std::int16_t> ball(const CtVolume& ct, Vec3 patient_mm, double radius_mm) {
  const Selection chosen = brushed(ct.geometry, std::array{patient_mm}, {.radius_mm = radius_mm});
  std::vector<std::int16_t> values;
  const VoxelBox& box = chosen.box;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i)
        if (chosen.chosen(i, j, k)) values.push_back(ct.at(i, j, k));
  return values;
}

double median(std::vector<std::int16_t>& values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

double BloodLevel::unlikeness(double hu) const {
  const double off = hu < blood_HU ? (blood_HU - hu) / (blood_HU - low_HU) : (hu - blood_HU) / (high_HU - blood_HU);
  return std::min(off * off, kMost);
}

BloodLevel bloodAt(const CtVolume& ct, Vec3 patient_mm, double reach_mm) {
  const Vec3& s = ct.geometry.spacing_mm;
  const double radius_mm = std::max(kBlood_mm, 1.01 * std::min({s.x, s.y, s.z}));  // a voxel and its neighbours
  std::vector<std::int16_t> inside = ball(ct, patient_mm, radius_mm), around = ball(ct, patient_mm, reach_mm);
  const double blood_HU = median(inside);
  std::erase_if(around, [=](std::int16_t hu) { return hu < kTissueFrom_HU || hu > blood_HU - kTissueBelowBlood_HU; });
  const double tissue_HU = around.empty() ? kUsualTissue_HU : median(around);
  const double half_HU = (blood_HU - tissue_HU) / 2;
  return {blood_HU - kLimit * half_HU, blood_HU, blood_HU + kLimit * half_HU, blood_HU - half_HU};
}

BloodLevel mixed(const BloodLevel& a, const BloodLevel& b, double share) {
  const auto mix = [=](double from, double to) { return from + (to - from) * share; };
  return {mix(a.low_HU, b.low_HU), mix(a.blood_HU, b.blood_HU), mix(a.high_HU, b.high_HU), mix(a.half_HU, b.half_HU)};
}

}  // namespace insonate::segmentation
