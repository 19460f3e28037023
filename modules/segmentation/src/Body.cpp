#include "Body.h"

#include "Components.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>

namespace insonate::segmentation {
namespace {

// Couch shells, head rests and cloth are thinner than twice this; necks, arms and chest walls are thicker.
constexpr double kThinMatter_mm = 4;
// Noses and lips that the opening took are given back within this reach; a couch that touches is not followed farther.
constexpr double kGiveBack_mm = 8;
// Openings narrower than twice this do not let outside air in: nostrils and lips, but not the gap between arm and head.
constexpr double kSeal_mm = 5;
// Outside air is close to -1000 HU; lung that a cropped scan cuts is not.
constexpr double kOutsideAir_HU = -900;
// A skin fold is open to the outside along its length, an airway at its mouth only: mm2 of opening for each mm3.
constexpr double kFoldOpening_per_mm = 0.02;
// Smaller pockets are streaks of dental metal or cells of bone.
constexpr double kSmallestAirway_mm3 = 100;

/// The storage axis that runs nearest to head-foot. The scan's two ends along it are cuts through the patient, and air
/// there may be trachea; at the other four faces it is outside air.
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

/// Means with padding (-1024, -3024, ...) counted as air.
std::vector<double> meanHounsfield(const Components& components, const CtVolume& ct) {
  std::vector<double> sum(components.count(), 0);
  for (const auto& run : components.runs())
    for (int i = run.begin; i < run.end; ++i) sum[run.component] += std::max<int>(ct.at(i, run.j, run.k), -1000);
  const auto sizes = components.sizes();
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] /= static_cast<double>(sizes[c]);
  return sum;
}

/// In place: mask &= (HU > kMatter_HU).
void keepMatter(Mask& mask, const CtVolume& ct, Work& work) {
  const std::size_t slice = std::size_t(ct.geometry.size[0]) * ct.geometry.size[1];
  work.slices(ct.geometry.size[2], [&](int k) {
    for (std::size_t v = k * slice; v < (k + 1) * slice; ++v)
      mask.voxels[v] &= static_cast<std::uint8_t>(ct.voxels[v] > kMatter_HU);
  });
}

/// The largest thick piece of matter, with its thin parts; empty when there is none.
std::optional<Mask> largestBody(const CtVolume& ct, Work& work) {
  Mask body(ct.geometry, 1);
  keepMatter(body, ct, work);
  open(body, kThinMatter_mm, work);
  const Components pieces(body, Components::Reach::Volume, work);
  if (pieces.count() == 0) return std::nullopt;
  const auto sizes = pieces.sizes();
  std::vector<bool> others(pieces.count(), true);
  others[std::max_element(sizes.begin(), sizes.end()) - sizes.begin()] = false;
  pieces.paint(others, 0, body);
  dilate(body, kGiveBack_mm, work);
  keepMatter(body, ct, work);
  return body;
}

/// Opening area (mm2) of each component toward the outside.
std::vector<double> openingToOutside(const Components& components, const Mask& outside) {
  const auto& g = outside.geometry;
  const double iFace = g.spacing_mm.y * g.spacing_mm.z, jFace = g.spacing_mm.x * g.spacing_mm.z,
               kFace = g.spacing_mm.x * g.spacing_mm.y;
  const auto is = [&](int i, int j, int k) { return g.contains(i, j, k) && outside.at(i, j, k); };
  std::vector<double> area(components.count(), 0);
  for (const auto& run : components.runs()) {
    double& a = area[run.component];
    a += iFace * (is(run.begin - 1, run.j, run.k) + is(run.end, run.j, run.k));
    for (int i = run.begin; i < run.end; ++i) {
      a += jFace * (is(i, run.j - 1, run.k) + is(i, run.j + 1, run.k));
      a += kFace * (is(i, run.j, run.k - 1) + is(i, run.j, run.k + 1));
    }
  }
  return area;
}

struct Air {
  Mask outside;
  Mask wide;  ///< where a ball of kSeal_mm fits
};

/// Air that a ball of kSeal_mm can reach from the sides of the scan.
Air openAir(const CtVolume& ct, const Mask& air, Work& work) {
  Mask wide = air;
  erode(wide, kSeal_mm, work);
  const Components pieces(wide, Components::Reach::Volume, work);
  std::vector<bool> isOutside = touchingSide(pieces, ct.geometry);
  const auto mean_HU = meanHounsfield(pieces, ct);
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
  const auto opening_mm2 = openingToOutside(pockets, open.outside);
  const auto sizes = pockets.sizes();
  std::vector<bool> hasWidth(pockets.count(), false);
  for (const auto& run : pockets.runs())
    for (int i = run.begin; i < run.end && !hasWidth[run.component]; ++i)
      hasWidth[run.component] = open.wide.at(i, run.j, run.k);

  const auto& s = ct.geometry.spacing_mm;
  std::vector<bool> isFold(pockets.count()), isAirway(pockets.count());
  for (std::size_t p = 0; p < pockets.count(); ++p) {
    const double volume_mm3 = static_cast<double>(sizes[p]) * s.x * s.y * s.z;
    isFold[p] = opening_mm2[p] > kFoldOpening_per_mm * volume_mm3 || (atSide[p] && !hasWidth[p]);
    isAirway[p] = !isFold[p] && volume_mm3 >= kSmallestAirway_mm3;
  }
  pockets.paint(isFold, kBackground, labels);
  pockets.paint(isAirway, kAirway, labels);
  return labels;
}

}  // namespace insonate::segmentation
