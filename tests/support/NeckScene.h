#pragma once

#include "support/AnalyticPlane.h"

#include <insonate/deformation/DeformationModel.h>

#include <algorithm>
#include <cmath>

namespace insonate::test {

/// Skin, fat and soft tissue over a vertebra, a vein of 12 mm and an artery of 7 mm beside each other.
inline AnalyticPlane neckScene() {
  AnalyticPlane plane;
  plane.layers = {{1.5, kSkin}, {3, kFat}};
  plane.circles = {{-7, 13, 6, kVein}, {8, 15, 3.5, kArtery}};
  plane.blocks = {{-60, 38, 60, 80, kBone}};
  return plane;
}

inline double areaRatio(const Deformation& answer, std::uint8_t label) {
  for (const LumenArea& lumen : answer.lumens)
    if (lumen.label == label) return lumen.area_mm2 / lumen.rest_mm2;
  return -1;
}

/// RMS and largest distance between the places of two answers' nodes, on the same mesh.
struct NodeDifference {
  double rms_mm = 0, max_mm = 0;
};
template <class Counts>
NodeDifference nodeDifference(const Deformation& a, const Deformation& b, Counts&& counts) {
  NodeDifference difference;
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < a.mesh.size(); ++n) {
    if (!counts(a.mesh[n])) continue;
    const double d = std::hypot(a.mesh[n].x_mm - b.mesh[n].x_mm, a.mesh[n].z_mm - b.mesh[n].z_mm);
    sum += d * d;
    ++count;
    difference.max_mm = std::max(difference.max_mm, d);
  }
  difference.rms_mm = std::sqrt(sum / std::max(count, 1));
  return difference;
}

/// Points of the lattice between which the seen tissue is turned over; and those that are no number.
struct Folds {
  int folded = 0, notFinite = 0;
};
inline Folds foldsOf(const PlaneDisplacement& d) {
  Folds folds;
  const auto rest = [&](int c, int r) {
    const auto& shift = d.restFromDisplayed[std::size_t(r) * d.columns + c];
    return PlaneDisplacement::Shift{float(c * d.step_mm + shift.x_mm), float(r * d.step_mm + shift.z_mm)};
  };
  for (int r = 0; r + 1 < d.rows; ++r)
    for (int c = 0; c + 1 < d.columns; ++c) {
      const auto a = rest(c, r), b = rest(c + 1, r), e = rest(c, r + 1);
      folds.notFinite += !std::isfinite(a.x_mm) || !std::isfinite(a.z_mm);
      folds.folded += !((b.x_mm - a.x_mm) * (e.z_mm - a.z_mm) - (b.z_mm - a.z_mm) * (e.x_mm - a.x_mm) > -1e-6f);
    }
  return folds;
}

}  // namespace insonate::test
