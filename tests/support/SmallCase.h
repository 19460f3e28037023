#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>

namespace insonate::test {

/// A block of soft tissue, quick to render: skin in front (facing -y) at y = 0 mm, a vein along z at depth 12 mm, bone
/// from 26 mm on. Patient LPS, x from -24 to 24, y from -6 to 34, z from -8 to 8, 1 mm voxels.
inline PatientCase smallCase() {
  VolumeGeometry grid;
  grid.size = {49, 41, 17};
  grid.origin_mm = {-24, -6, -8};
  PatientCase patient{{}, CtVolume(grid, -1000), LabelMap(grid)};
  patient.manifest.title = "Small block";
  patient.manifest.targets = {{"vein", kVein, {0, 12, 0}}};
  patient.manifest.startPoses = {{"over the vein", {0, 0, 0}, {0, 1, 0}, {1, 0, 0}}};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 6; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const double x = i - 24, depth = j - 6;
        const bool vein = std::hypot(x, depth - 12) < 5;
        const Label label = depth < 2 ? kSkin : vein ? kVein : depth >= 26 ? kBone : kSoftTissue;
        patient.labels.at(i, j, k) = label;
        patient.ct.at(i, j, k) = label == kBone ? 900 : label == kVein ? 45 : 30;
      }
  return patient;
}

/// The same with an artery along z, 20 mm beside the vein, so that attempts can be made on it.
inline PatientCase smallAttemptCase() {
  PatientCase patient = smallCase();
  for (int k = 0; k < 17; ++k)
    for (int j = 16; j < 21; ++j)
      for (int i = 2; i < 7; ++i) patient.labels.at(i, j, k) = kArtery;
  return patient;
}

/// A label of an author's own.
inline constexpr std::uint8_t kOwnLabel = kLabelCount;

/// The block with its bone as a label of the author's own, said to be made of this.
inline PatientCase smallCaseWithOwnLabel(Label tissue) {
  PatientCase patient = smallCase();
  std::ranges::replace(patient.labels.voxels, std::uint8_t{kBone}, kOwnLabel);
  patient.manifest.ownLabels = {{kOwnLabel, {"rib", tissue}}};
  return patient;
}

}  // namespace insonate::test
