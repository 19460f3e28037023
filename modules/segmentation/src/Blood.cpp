#include "Blood.h"

#include "Components.h"

#include <insonate/segmentation/Region.h>
#include <insonate/tissue/Labels.h>

#include <cmath>

namespace insonate::segmentation {
namespace {

/// Ranges of blood in a CT angiogram, in a venous phase and in early venous return: separate ranges, so that a vessel
/// is not connected with the bone beside it.
constexpr HuRange kWindows[] = {{351, 700}, {201, 400}, {141, 260}};
constexpr int kRise_HU = 120;          // the path out of marrow first rises through cortex, that out of blood does not
constexpr double kRadius_mm = 3;       // radius of the thinnest vessel that is found
constexpr double kSmallest_mm3 = 600;  // two centimeters of carotid
constexpr double kEven_HU = 55;        // the noise of a CT angiogram is below this, that of trabeculae and cortex above
constexpr double kSoftShare = 0.55;    // share of the blood's brightness
constexpr double kWall_mm = 5;         // soft tissue begins within this distance of the edge of blood; beside marrow
                                       // there is cortex
constexpr double kBordered = 0.45;

struct Step {
  int i, j, k;
  double length_mm;
};

/// Tells whether the CT falls to soft tissue within kWall_mm of a voxel in a direction, without rising before.
bool fallsToSoft(const CtVolume& ct, int i, int j, int k, const Step& step) {
  const int from_HU = ct.at(i, j, k);
  const int reach = std::max(1, static_cast<int>(kWall_mm / step.length_mm));
  for (int n = 1; n <= reach; ++n) {
    const int x = i + n * step.i, y = j + n * step.j, z = k + n * step.k;
    if (!ct.geometry.contains(x, y, z)) return false;
    const int hu = ct.at(x, y, z);
    if (hu > from_HU + kRise_HU) return false;
    if (hu < kSoftShare * from_HU) return true;
  }
  return false;
}

struct Piece {
  double sum = 0, squares = 0;
  std::size_t voxels = 0, edges = 0, softEdges = 0;

  bool isBlood(double voxel_mm3) const {
    const auto n = static_cast<double>(voxels);
    const double mean_HU = sum / n, sd_HU = std::sqrt(std::max(0.0, squares / n - mean_HU * mean_HU));
    return n * voxel_mm3 >= kSmallest_mm3 && sd_HU < kEven_HU &&
           static_cast<double>(softEdges) >= kBordered * static_cast<double>(edges);
  }
};

std::vector<Piece> measure(const Components& components, const CtVolume& ct, const Mask& mask) {
  const auto& g = ct.geometry;
  const auto& s = g.spacing_mm;
  const std::array<Step, 6> steps{
      {{-1, 0, 0, s.x}, {1, 0, 0, s.x}, {0, -1, 0, s.y}, {0, 1, 0, s.y}, {0, 0, -1, s.z}, {0, 0, 1, s.z}}};
  std::vector<Piece> pieces(components.count());
  for (const auto& run : components.runs()) {
    Piece& piece = pieces[run.component];
    for (int i = run.begin; i < run.end; ++i) {
      const double hu = ct.at(i, run.j, run.k);
      piece.sum += hu;
      piece.squares += hu * hu;
      ++piece.voxels;
      for (const Step& step : steps) {
        const int x = i + step.i, y = run.j + step.j, z = run.k + step.k;
        if (g.contains(x, y, z) && mask.at(x, y, z)) continue;
        ++piece.edges;
        piece.softEdges += fallsToSoft(ct, i, run.j, run.k, step);
      }
    }
  }
  return pieces;
}

/// Adds the blood within one range.
void findIn(HuRange window, const CtVolume& ct, const LabelMap& body, BrightBlood& blood, Work& work) {
  Mask bright(ct.geometry);
  work.voxels(ct.geometry, [&](std::size_t v) {
    bright.voxels[v] = body.voxels[v] == kSoftTissue && window.contains(ct.voxels[v]);
  });
  open(bright, kRadius_mm, work);

  const Components components(bright, Components::Reach::Volume, work);
  const std::vector<Piece> pieces = measure(components, ct, bright);
  const auto& s = ct.geometry.spacing_mm;
  std::vector<bool> removed(pieces.size());
  bool found = false;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    removed[p] = !pieces[p].isBlood(s.x * s.y * s.z);
    found = found || !removed[p];
  }
  if (!found) return;
  components.paint(removed, 0, bright);
  blood.present = true;
  // The opening has removed corners and branches.
  dilate(bright, kRadius_mm, work);
  work.voxels(ct.geometry, [&](std::size_t v) {
    blood.mask.voxels[v] |= std::uint8_t(bright.voxels[v] && ct.voxels[v] <= window.high);
  });
}

}  // namespace

BrightBlood findBrightBlood(const CtVolume& ct, const LabelMap& body, Work& work) {
  BrightBlood blood{false, Mask(ct.geometry)};
  for (const HuRange window : kWindows) findIn(window, ct, body, blood, work);
  return blood;
}

}  // namespace insonate::segmentation
