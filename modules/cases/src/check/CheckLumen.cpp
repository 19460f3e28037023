#include "Checks.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace insonate::check {
namespace {

/// CT values of a lumen's median: an error below or above the outer limits, a warning outside the inner limits.
struct LumenLimits {
  int impossibleLow, unusualLow, unusualHigh, impossibleHigh;
};

/// Whole blood of hematocrit 0.45 has about 55 HU, plasma about 25 HU (New and Aronow, Radiology 1976; 121: 635-40), so
/// that blood without contrast agent has 20 to 90 HU. With contrast agent it reaches 600 HU, and more only in veins
/// that carry the injected bolus undiluted. The tolerances beyond are our choice.
constexpr LumenLimits kInner{-20, 20, 600, 900};
/// Limits without inner voxels: the values then include the wall and the fat around it.
constexpr LumenLimits kWithWall{-100, -100, 900, 900};

constexpr int kBlood_HU[] = {20, 90, 600};

/// Voxels of a vessel that has a name, or of all vessels of a label that have none.
struct Lumen {
  std::string what;
  std::uint8_t label = 0;
  std::vector<std::size_t> voxels;
};

/// Tells whether the six neighbors in the grid have the label, too: such a voxel has no partial volume of the wall.
bool isInner(const LabelMap& labels, std::array<int, 3> at, std::uint8_t label) {
  for (int axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      std::array<int, 3> beside = at;
      beside[axis] += step;
      if (labels.geometry.contains(beside[0], beside[1], beside[2]) &&
          labels.at(beside[0], beside[1], beside[2]) != label)
        return false;
    }
  return true;
}

/// Voxels of a label at most; more do not change the median.
constexpr std::size_t kEnough = 20000;

std::vector<std::size_t> sparse(const std::vector<std::size_t>& voxels) {
  const std::size_t step = voxels.size() / kEnough + 1;
  std::vector<std::size_t> some;
  for (std::size_t n = 0; n < voxels.size(); n += step) some.push_back(voxels[n]);
  return some;
}

struct LabelVoxels {
  std::vector<std::size_t> all, inner;
};

LabelVoxels voxelsOf(const LabelMap& labels, std::uint8_t label) {
  const VolumeGeometry& g = labels.geometry;
  LabelVoxels found;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        if (labels.at(i, j, k) != label) continue;
        found.all.push_back(g.offset(i, j, k));
        if (isInner(labels, {i, j, k}, label)) found.inner.push_back(found.all.back());
      }
  return {sparse(found.all), sparse(found.inner)};
}

/// Distributes voxels of a label among its named vessels; the last lumen takes those that lie in none.
std::vector<Lumen> lumensOf(const CaseView& patient, std::uint8_t label, const std::vector<std::size_t>& voxels) {
  constexpr double kFlat_mm = 4;  // beyond the wall of a round vessel, but still in the lumen of a flat one
  std::vector<Lumen> lumens;
  std::vector<const NamedVessel*> vessels;
  for (const NamedVessel& vessel : patient.manifest.vessels)
    if (vessel.label == label && !vessel.course.empty()) {
      vessels.push_back(&vessel);
      lumens.push_back({"the " + vessel.name, label, {}});
    }
  lumens.push_back(
      {vessels.empty() ? "the " + labelName(label) : "the " + labelName(label) + " without a name", label, {}});
  for (const std::size_t voxel : voxels) {
    const Vec3 place_mm = placeOf(patient.labels.geometry, voxel);
    std::size_t in = vessels.size();
    double nearest_mm = kFlat_mm;
    for (std::size_t n = 0; n < vessels.size(); ++n)
      if (const double distance_mm = distanceToWall_mm(*vessels[n], place_mm); distance_mm <= nearest_mm)
        in = n, nearest_mm = distance_mm;
    lumens[in].voxels.push_back(voxel);
  }
  return lumens;
}

std::string tissueLike(int median_HU) {
  if (median_HU < -400) return "air or lung";
  if (median_HU < -20) return "fat";
  if (median_HU < kBlood_HU[0]) return "water, or blood mixed with fat";
  return median_HU <= kInner.impossibleHigh ? "bone or undiluted contrast agent" : "bone or metal";
}

void judge(const CaseView& patient, Lumen& lumen, const LumenLimits& limits, Findings& findings) {
  const auto& hu = patient.ct.voxels;
  const auto middle = lumen.voxels.begin() + std::ptrdiff_t(lumen.voxels.size() / 2);
  const Vec3 place_mm = placeOf(patient.labels.geometry, *middle);
  std::ranges::nth_element(lumen.voxels, middle, {}, [&](std::size_t voxel) { return hu[voxel]; });
  const int median_HU = hu[*middle];
  if (median_HU >= limits.unusualLow && median_HU <= limits.unusualHigh) return;
  const bool isImpossible = median_HU < limits.impossibleLow || median_HU > limits.impossibleHigh;
  findings.push_back({isImpossible ? FindingSeverity::kError : FindingSeverity::kWarning, "lumen_hu",
                      "The lumen of " + lumen.what + " has a median of " + std::to_string(median_HU) + " HU, like " +
                          tissueLike(median_HU) + ". Blood has " + std::to_string(kBlood_HU[0]) + " to " +
                          std::to_string(kBlood_HU[1]) + " HU, with contrast agent up to " +
                          std::to_string(kBlood_HU[2]) + " HU. " +
                          (isImpossible ? "The label lies on other tissue: correct it."
                                        : "Check on the slices that the label lies in the vessel."),
                      place_mm, lumen.label});
}

}  // namespace

void checkLumens(const CaseView& patient, const LabelStatistics& statistics, Findings& findings) {
  constexpr std::size_t kFewInner = 20;
  if (statistics.minHu == statistics.maxHu) return;  // no CT
  for (const std::uint8_t label : {kVein, kArtery}) {
    if (!statistics.has(label)) continue;
    const LabelVoxels voxels = voxelsOf(patient.labels, label);
    std::vector<Lumen> whole = lumensOf(patient, label, voxels.all), inner = lumensOf(patient, label, voxels.inner);
    for (std::size_t n = 0; n < whole.size(); ++n)
      if (inner[n].voxels.size() >= kFewInner)
        judge(patient, inner[n], kInner, findings);
      else if (!whole[n].voxels.empty())
        judge(patient, whole[n], kWithWall, findings);
  }
}

}  // namespace insonate::check
