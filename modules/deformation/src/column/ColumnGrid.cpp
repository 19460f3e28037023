#include "ColumnGrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::column {

double ColumnGrid::profileSd_mm(double faceWidth_mm) {
  return faceWidth_mm / std::sqrt(2 * std::numbers::pi);
}

void ColumnGrid::layOut(double faceWidth_mm, const DeformationSettings& settings) {
  if (columnCount > 0 && faceWidth_mm == width && settings.depth_mm == bottom) return;
  width = faceWidth_mm;
  bottom = settings.depth_mm;
  const double sd_mm = profileSd_mm(faceWidth_mm);
  for (step = settings.mesh_mm;; step *= 1.25) {
    columnCount = 2 * static_cast<int>(std::ceil(kCovered * sd_mm / step)) + 1;
    rowCount = static_cast<int>(std::ceil((kReach_mm + bottom) / step));
    if (double(columnCount) * rowCount <= kMaxSprings) break;
  }
  points.resize(std::size_t(columnCount) * rowCount);
  tissue.resize(points.size());
  measured.resize(columnCount);
  weights.resize(columnCount);
  for (int c = 0; c < columnCount; ++c) {
    weights[c] = std::exp(-x_mm(c) * x_mm(c) / (2 * sd_mm * sd_mm));
    for (int r = 0; r < rowCount; ++r)
      points[at(c, r)] = {static_cast<float>(x_mm(c)), static_cast<float>(z_mm(r) + step / 2)};
  }
}

void ColumnGrid::sampleMiddle(const TissuePlane& plane) {
  const std::size_t first = at(middle(), 0);
  plane.sample({points.data() + first, std::size_t(rowCount)}, {tissue.data() + first, std::size_t(rowCount)});
  measured[middle()] = measure(middle());
}

void ColumnGrid::sampleAll(const TissuePlane& plane) {
  plane.sample(points, tissue);
  for (int c = 0; c < columnCount; ++c) measured[c] = measure(c);
}

TissueColumn ColumnGrid::measure(int column) const {
  const PlaneTissue* here = tissue.data() + at(column, 0);
  const auto inside = [&](int row) { return here[row].skin_mm < 0; };
  TissueColumn found;
  // The skin that the face meets: the next skin above a face in tissue, else below it, so that a chin above the probe
  // does not count.
  int row = std::clamp(static_cast<int>(std::floor((0 - z_mm(0)) / step)), 0, rowCount - 1);
  if (inside(row))
    while (row > 0 && inside(row - 1)) --row;
  else
    while (row < rowCount && !inside(row)) ++row;
  if (row == rowCount) return found;
  found.met = true;
  found.first = row;
  found.skinFound = row > 0;
  const double center_mm = z_mm(row) + step / 2;
  if (found.skinFound) {
    const double in = -here[row].skin_mm, out = here[row - 1].skin_mm;
    const double share = out >= 0 && in + out > 0 ? in / (in + out) : 0.5;
    found.skin_mm = center_mm - step * share;
  } else {
    found.skin_mm = z_mm(0);
  }
  found.length_mm[knownLabel(here[row].label)] += z_mm(row + 1) - found.skin_mm;
  for (int r = row + 1; r < rowCount; ++r) found.length_mm[knownLabel(here[r].label)] += step;
  return found;
}

}  // namespace insonate::column
