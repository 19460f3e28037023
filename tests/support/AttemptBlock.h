#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/tissue/Labels.h>

namespace insonate::test {

/// A block for attempts whose numbers can be worked out by hand: all walls are flat, and lie between voxels of 1 mm, so
/// that their places are exact. Patient LPS, mm; the skin faces -y.
///
///   skin     y = -0.5
///   vein     x -6.5 to 6.5, y 11.5 to 23.5, along z: its middle at x = 0, y = 17.5
///   artery   x 10.5 to 25.5, y 19.5 to 33.5, along z
///   bone     x below -14.5, y from 29.5
///   lung     all else from y = 39.5
///
/// Below the skin, the vein's walls are 12 and 24 mm deep, the artery's front 20, bone 30 and lung 40.
inline PatientCase attemptBlock() {
  VolumeGeometry grid;
  grid.size = {61, 71, 61};
  grid.origin_mm = {-30, -10, -30};
  PatientCase patient{{}, CtVolume(grid, -1000), LabelMap(grid)};
  patient.manifest.title = "Block for attempts";
  patient.manifest.targets = {{"vein", kVein, {0, 17.5, 0}}};
  patient.manifest.startPoses = {{"across", {0, -1, 0}, {0, 1, 0}, {1, 0, 0}},
                                 {"along", {0, -1, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 10; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const int x = i - 30, y = j - 10;
        const bool vein = x >= -6 && x <= 6 && y >= 12 && y <= 23, artery = x >= 11 && x <= 25 && y >= 20 && y <= 33;
        patient.labels.at(i, j, k) = y < 2                 ? kSkin
                                     : vein                ? kVein
                                     : artery              ? kArtery
                                     : x <= -15 && y >= 30 ? kBone
                                     : y >= 40             ? kAirway
                                                           : kSoftTissue;
        patient.ct.at(i, j, k) = 30;
      }
  return patient;
}

}  // namespace insonate::test
