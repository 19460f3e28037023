#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/VoxelBox.h>

#include <optional>

namespace insonate {

struct CropOptions {
  VoxelBox box;  ///< the part of the case to keep, in voxel indices of the original case
  /// spacing of the new voxels along the same axes; empty: the voxels are not resampled
  std::optional<Vec3> spacing_mm{};
};

/// Returns the box of voxels between two opposite corners (patient LPS), which may be given in any order.
VoxelBox boxBetween(const VolumeGeometry& geometry, Vec3 corner_mm, Vec3 opposite_mm);

/// Returns the grid of the case that cropCase() makes. The borders of this grid and of the box coincide within half a
/// new voxel. Fails on an empty box, a box beyond the grid, and a spacing outside a scanner's range.
Result<VolumeGeometry> croppedGrid(const VolumeGeometry& geometry, const CropOptions& options);

/// Crops CT and labels of a case, with the same or another spacing. A new voxel's HU is the mean of the linearly
/// interpolated CT over the voxel; its label is the one with the largest share of the voxel. Each label is interpolated
/// separately, so that thin walls stay connected; nearest-voxel resampling would interrupt them. Where a vein and an
/// artery would touch, the voxel with more of the tissue between them gets the label of this tissue, if it has a tenth
/// of the voxel; a note states where none was left. Title, colors, targets and start poses are kept, in patient
/// coordinates; targets outside the crop are removed. The import notes list the changes. Uses all cores. The result is
/// bit-identical on any number of threads. Fails with the errors of croppedGrid(), and when cancelled.
Result<PatientCase> cropCase(const PatientCase& patient, const CropOptions& options, const Progress& progress = {});

}  // namespace insonate
