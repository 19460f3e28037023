#include "Blood.h"

#include "Components.h"

#include <insonate/tissue/Labels.h>

#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr int kFrom_HU = 350, kTo_HU = 700;
constexpr double kRadius_mm = 3;       // of the thinnest vessel that is found
constexpr double kSmallest_mm3 = 600;  // two centimetres of carotid
constexpr double kEven_HU = 55;        // noise of a CT angiogram stays below, trabeculae and cortex do not
constexpr int kSoft_HU = 180;
constexpr double kWall_mm = 5;  // beyond the edge of blood it is soft within this; beyond marrow there is cortex
constexpr double kBordered = 0.45;

struct Step {
  int i, j, k;
  double length_mm;
};

/// Whether the CT falls to soft tissue within kWall_mm of a voxel in a direction.
bool fallsToSoft(const CtVolume& ct, int i, int j, int k, const Step& step) {
  const int reach = std::max(1, static_cast<int>(kWall_mm / step.length_mm));
  for (int n = 1; n <= reach; ++n) {
    const int x = i + n * step.i, y = j + n * step.j, z = k + n * step.k;
    if (!ct.geometry.contains(x, y, z)) return false;
    if (ct.at(x, y, z) < kSoft_HU) return true;
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

}  // namespace

BrightBlood findBrightBlood(const CtVolume& ct, const LabelMap& body, Work& work) {
  const auto inRange = [&](std::size_t v) {
    return body.voxels[v] == kSoftTissue && ct.voxels[v] > kFrom_HU && ct.voxels[v] <= kTo_HU;
  };
  BrightBlood blood{false, Mask(ct.geometry)};
  work.voxels(ct.geometry, [&](std::size_t v) { blood.mask.voxels[v] = inRange(v); });
  open(blood.mask, kRadius_mm, work);

  const Components components(blood.mask, Components::Reach::Volume, work);
  const std::vector<Piece> pieces = measure(components, ct, blood.mask);
  const auto& s = ct.geometry.spacing_mm;
  std::vector<bool> removed(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    removed[p] = !pieces[p].isBlood(s.x * s.y * s.z);
    if (!removed[p]) blood.present = true;
  }
  components.paint(removed, 0, blood.mask);
  if (!blood.present) return blood;

  // The opening took corners and branches.
  dilate(blood.mask, kRadius_mm, work);
  work.voxels(ct.geometry, [&](std::size_t v) { blood.mask.voxels[v] &= std::uint8_t(ct.voxels[v] <= kTo_HU); });
  return blood;
}

}  // namespace insonate::segmentation
