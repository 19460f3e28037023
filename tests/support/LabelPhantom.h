#pragma once

#include <insonate/image/Volume.h>

#include <algorithm>
#include <cmath>

namespace insonate::test {

/// A small synthetic patient.
struct LabelPhantom {
  CtVolume ct;
  LabelMap labels;
};

/// Axis-aligned grid whose outermost voxel faces lie on the box, patient LPS mm; the spacing is rounded to fit.
inline VolumeGeometry gridOver(Vec3 low_mm, Vec3 high_mm, Vec3 spacing_mm) {
  VolumeGeometry grid;
  for (int a = 0; a < 3; ++a) {
    const double length_mm = high_mm[a] - low_mm[a];
    grid.size[a] = std::max(1, static_cast<int>(std::lround(length_mm / spacing_mm[a])));
    grid.spacing_mm[a] = length_mm / grid.size[a];
    grid.origin_mm[a] = low_mm[a] + grid.spacing_mm[a] / 2;
  }
  return grid;
}

inline VolumeGeometry gridOver(Vec3 low_mm, Vec3 high_mm, double spacing_mm) {
  return gridOver(low_mm, high_mm, Vec3{spacing_mm, spacing_mm, spacing_mm});
}

/// Labels and HU of an analytic object, taken at the voxel centers: `labelAt(patient_mm)`, `huAt(patient_mm)`.
template <class LabelAt, class HuAt>
LabelPhantom paint(const VolumeGeometry& grid, const LabelAt& labelAt, const HuAt& huAt) {
  LabelPhantom phantom{CtVolume(grid), LabelMap(grid)};
  const Transform patientFromIndex = grid.patientFromIndex();
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        phantom.labels.at(i, j, k) = static_cast<std::uint8_t>(labelAt(p));
        phantom.ct.at(i, j, k) = static_cast<std::int16_t>(huAt(p));
      }
  return phantom;
}

template <class LabelAt>
LabelPhantom paint(const VolumeGeometry& grid, const LabelAt& labelAt) {
  return paint(grid, labelAt, [](Vec3) { return 0; });
}

}  // namespace insonate::test
