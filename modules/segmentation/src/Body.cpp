#include "Body.h"

#include "Components.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>

namespace insonate::segmentation {
namespace {

// Couch shells, head rests and cloth are thinner than twice this; necks, arms and chest walls are thicker.
constexpr double kThinMatter_mm = 4;
// Noses and lips that the opening removed are restored within this distance; a touching couch is not followed farther.
constexpr double kGiveBack_mm = 8;
// Openings narrower than twice this are closed to outside air: nostrils and lips, but not the gap between arm and head.
constexpr double kSeal_mm = 5;
// Outside air is close to -1000 HU; lung at the cut of a cropped scan is not.
constexpr double kOutsideAir_HU = -900;
// A skin fold is open to the outside along its length, an airway at its mouth only: limits of the opening for each mm3
// of volume and for each mm2 of surface.
constexpr double kFoldOpening_per_mm = 0.02, kFoldOpening = 0.04;
// Smaller pockets are streaks of dental metal or cavities of bone.
constexpr double kSmallestAirway_mm3 = 100;

/// The storage axis closest to head-foot. The scan's two ends along it cut the patient, and air there may be trachea;
/// at the other four faces it is outside air.
int headFootAxis(const VolumeGeometry& g) {
  int axis = 2;
  for (int a = 1; a >= 0; --a)
    if (std::abs(g.direction.column[a].z) > std::abs(g.direction.column[axis].z)) axis = a;
  return axis;
}

bool touchesSide(const Components::Run& run, const VolumeGeometry& g, int headFoot) {
  const auto& size = g.size;
  return (headFoot != 0 && (run.begin == 0 || run.end == size[0])) ||
         (headFoot != 1 && (run.j == 0 || run.j + 1 == size[1])) ||
         (headFoot != 2 && (run.k == 0 || run.k + 1 == size[2]));
}

std::vector<bool> touchingSide(const Components& components, const VolumeGeometry& g) {
  std::vector<bool> touching(components.count(), false);
  const int axis = headFootAxis(g);
  for (const auto& run : components.runs())
    if (touchesSide(run, g, axis)) touching[run.component] = true;
  return touching;
}

/// Mean CT value of the air in each; matter in it (a couch, another arm) is excluded, padding (-1024, -3024, ...) is
/// air.
std::vector<double> meanOfAir_HU(const Components& components, const CtVolume& ct) {
  std::vector<double> sum(components.count(), 0), voxels(components.count(), 0);
  for (const auto& run : components.runs())
    for (int i = run.begin; i < run.end; ++i) {
      const int hu = ct.at(i, run.j, run.k);
      if (hu > kMatter_HU) continue;
      sum[run.component] += std::max(hu, -1000);
      voxels[run.component] += 1;
    }
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] /= std::max(voxels[c], 1.0);
  return sum;
}

/// Computes in place: mask &= (HU > kMatter_HU).
void keepMatter(Mask& mask, const CtVolume& ct, Work& work) {
  work.voxels(ct.geometry,
              [&](std::size_t v) { mask.voxels[v] &= static_cast<std::uint8_t>(ct.voxels[v] > kMatter_HU); });
}

/// False if there is no component.
bool keepLargest(Mask& mask, Work& work) {
  const Components pieces(mask, Components::Reach::Volume, work);
  if (pieces.count() == 0) return false;
  const auto sizes = pieces.sizes();
  std::vector<bool> others(pieces.count(), true);
  others[std::max_element(sizes.begin(), sizes.end()) - sizes.begin()] = false;
  pieces.paint(others, 0, mask);
  return true;
}

/// The largest thick piece of matter with its thin parts; empty if there is none.
std::optional<Mask> largestBody(const CtVolume& ct, Work& work) {
  Mask body(ct.geometry, 1);
  keepMatter(body, ct, work);
  open(body, kThinMatter_mm, work);
  if (!keepLargest(body, work)) return std::nullopt;
  dilate(body, kGiveBack_mm, work);
  keepMatter(body, ct, work);
  keepLargest(body, work);  // the reach may cross narrow air to an arm or the couch
  return body;
}

struct Surface_mm2 {
  double all = 0, toOutside = 0;
};

/// Surface of each component of `air`, and the part of it that opens to the outside.
std::vector<Surface_mm2> surfaces(const Components& components, const Mask& air, const Mask& outside) {
  const auto& g = air.geometry;
  const auto& s = g.spacing_mm;
  std::vector<Surface_mm2> surfaces(components.count());
  for (const auto& run : components.runs()) {
    const auto face = [&](int i, int j, int k, double area_mm2) {
      if (!g.contains(i, j, k) || air.at(i, j, k)) return;
      surfaces[run.component].all += area_mm2;
      if (outside.at(i, j, k)) surfaces[run.component].toOutside += area_mm2;
    };
    face(run.begin - 1, run.j, run.k, s.y * s.z);
    face(run.end, run.j, run.k, s.y * s.z);
    for (int i = run.begin; i < run.end; ++i) {
      for (const int step : {-1, 1}) {
        face(i, run.j + step, run.k, s.x * s.z);
        face(i, run.j, run.k + step, s.x * s.y);
      }
    }
  }
  return surfaces;
}

struct Air {
  Mask outside;
  Mask wide;  ///< places where a ball of kSeal_mm fits
};

/// Air that a ball of kSeal_mm can reach from the sides of the scan.
Air openAir(const CtVolume& ct, const Mask& air, Work& work) {
  Mask wide = air;
  erode(wide, kSeal_mm, work);
  const Components pieces(wide, Components::Reach::Volume, work);
  std::vector<bool> isOutside = touchingSide(pieces, ct.geometry);
  const auto mean_HU = meanOfAir_HU(pieces, ct);
  for (std::size_t c = 0; c < isOutside.size(); ++c) isOutside[c] = isOutside[c] && mean_HU[c] < kOutsideAir_HU;
  Mask outside(ct.geometry);
  pieces.paint(isOutside, 1, outside);
  dilate(outside, kSeal_mm, work);
  for (std::size_t v = 0; v < air.voxels.size(); ++v) outside.voxels[v] &= air.voxels[v];
  return {std::move(outside), std::move(wide)};
}

}  // namespace

std::optional<LabelMap> findBody(const CtVolume& ct, Work& work) {
  std::optional<Mask> body = largestBody(ct, work);
  if (!body) return std::nullopt;
  Mask air = std::move(*body);
  for (std::uint8_t& v : air.voxels) v ^= 1;

  const Air open = openAir(ct, air, work);
  LabelMap labels(ct.geometry, kSoftTissue);
  for (std::size_t v = 0; v < air.voxels.size(); ++v) {
    if (open.outside.voxels[v]) labels.voxels[v] = kBackground;
    air.voxels[v] &= open.outside.voxels[v] ^ 1;
  }

  const Components pockets(air, Components::Reach::Volume, work);
  const auto atSide = touchingSide(pockets, ct.geometry);
  const auto surface = surfaces(pockets, air, open.outside);
  const auto sizes = pockets.sizes();
  std::vector<bool> hasWidth(pockets.count(), false);
  for (const auto& run : pockets.runs())
    for (int i = run.begin; i < run.end && !hasWidth[run.component]; ++i)
      hasWidth[run.component] = open.wide.at(i, run.j, run.k);

  const auto& s = ct.geometry.spacing_mm;
  std::vector<bool> isFold(pockets.count()), isAirway(pockets.count());
  for (std::size_t p = 0; p < pockets.count(); ++p) {
    const double volume_mm3 = static_cast<double>(sizes[p]) * s.x * s.y * s.z;
    const bool opensWidely =
        surface[p].toOutside > kFoldOpening_per_mm * volume_mm3 && surface[p].toOutside > kFoldOpening * surface[p].all;
    isFold[p] = opensWidely || (atSide[p] && !hasWidth[p]);
    isAirway[p] = !isFold[p] && volume_mm3 >= kSmallestAirway_mm3;
  }
  pockets.paint(isFold, kBackground, labels);
  pockets.paint(isAirway, kAirway, labels);
  return labels;
}

}  // namespace insonate::segmentation
