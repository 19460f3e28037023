#include "BloodLevel.h"

#include <insonate/segmentation/Brush.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr double kBlood_mm = 1.2;     // radius of the ball whose median is the level of the blood
constexpr int kTissueFrom_HU = -120;  // air and lung do not indicate where blood ends
constexpr int kTissueBelowBlood_HU = 30;
constexpr double kUsualTissue_HU = 50;  // level of muscle, used if no tissue darker than blood is near
constexpr double kLimit = 0.6;          // share of the distance to half
constexpr double kMost = 4;
constexpr std::size_t kSameBlood = 5;  // the level of a click is the median over this number of stations on both sides
constexpr double kOtherBlood = 4.5;    // standard deviations by which noise may change a click's own level
constexpr double kSigma = 1.4826;      // ratio of SD to median absolute deviation, normal distribution

std::vector<std::int16_t> ball(const CtVolume& ct, Vec3 patient_mm, double radius_mm) {
  const Selection chosen = strokeVoxels(ct.geometry, std::array{patient_mm}, {.radius_mm = radius_mm});
  std::vector<std::int16_t> values;
  const VoxelBox& box = chosen.box;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i)
        if (chosen.isSelected(i, j, k)) values.push_back(ct.at(i, j, k));
  return values;
}

template <class T>
double median(std::vector<T>& values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

BloodLevel levelOf(double blood_HU, double half_HU) {
  return {blood_HU - kLimit * half_HU, blood_HU, blood_HU + kLimit * half_HU, blood_HU - half_HU};
}

/// Medians of the levels around a station.
BloodLevel middleAround(const std::vector<BloodLevel>& found, std::size_t station) {
  const std::size_t from = station > kSameBlood ? station - kSameBlood : 0;
  std::vector<double> blood, half;
  for (std::size_t n = from; n < std::min(station + kSameBlood + 1, found.size()); ++n) {
    blood.push_back(found[n].blood_HU);
    half.push_back(found[n].blood_HU - found[n].half_HU);
  }
  return levelOf(median(blood), median(half));
}

}  // namespace

double BloodLevel::unlikeness(double hu) const {
  const double off = hu < blood_HU ? (blood_HU - hu) / (blood_HU - low_HU) : (hu - blood_HU) / (high_HU - blood_HU);
  return std::min(off * off, kMost);
}

BloodLevel bloodAt(const CtVolume& ct, Vec3 patient_mm, double reach_mm) {
  const Vec3& s = ct.geometry.spacing_mm;
  const double radius_mm = std::max(kBlood_mm, 1.01 * std::min({s.x, s.y, s.z}));  // at least a voxel and its neighbors
  std::vector<std::int16_t> inside = ball(ct, patient_mm, radius_mm), around = ball(ct, patient_mm, reach_mm);
  const double blood_HU = median(inside);
  std::erase_if(around, [=](std::int16_t hu) { return hu < kTissueFrom_HU || hu > blood_HU - kTissueBelowBlood_HU; });
  const double tissue_HU = around.empty() ? kUsualTissue_HU : median(around);
  const double half_HU = (blood_HU - tissue_HU) / 2;
  return levelOf(blood_HU, half_HU);
}

BloodLevel mixed(const BloodLevel& a, const BloodLevel& b, double share) {
  const auto mix = [=](double from, double to) { return from + (to - from) * share; };
  return {mix(a.low_HU, b.low_HU), mix(a.blood_HU, b.blood_HU), mix(a.high_HU, b.high_HU), mix(a.half_HU, b.half_HU)};
}

std::vector<BloodLevel> measured(const std::vector<BloodLevel>& levels, const std::vector<double>& blood_HU) {
  std::vector<BloodLevel> now;
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const double tissue_HU = 2 * levels[n].half_HU - levels[n].blood_HU;
    now.push_back(levelOf(blood_HU[n], std::max(blood_HU[n] - tissue_HU, double(kTissueBelowBlood_HU)) / 2));
  }
  std::vector<BloodLevel> even;
  for (std::size_t n = 0; n < now.size(); ++n) even.push_back(middleAround(now, n));
  return even;
}

std::vector<BloodLevel> levelsAtClicks(const CtVolume& ct, std::span<const Vec3> clicks_mm,
                                       std::span<const Vec3> way_mm, std::span<const std::size_t> clickOnWay,
                                       double reach_mm, Work& work) {
  std::vector<BloodLevel> found(way_mm.size());
  work.slices(static_cast<int>(found.size()), [&](int n) { found[n] = bloodAt(ct, way_mm[n], reach_mm); });
  std::vector<double> off;
  for (std::size_t n = 0; n < found.size(); ++n)
    off.push_back(std::abs(found[n].blood_HU - middleAround(found, n).blood_HU));
  const double scatter_HU = kSigma * median(off);
  std::vector<BloodLevel> levels;
  for (std::size_t n = 0; n < clicks_mm.size(); ++n) {
    const BloodLevel own = bloodAt(ct, clicks_mm[n], reach_mm), middle = middleAround(found, clickOnWay[n]);
    levels.push_back(std::abs(own.blood_HU - middle.blood_HU) > kOtherBlood * scatter_HU ? own : middle);
  }
  return levels;
}

}  // namespace insonate::segmentation
