#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/VoxelBox.h>

#include <optional>

namespace insonate {

struct CropOptions {
  VoxelBox box;                      ///< what is kept, in the case's own voxels
  std::optional<Vec3> spacing_mm{};  ///< of the new grid along the same axes; without, voxels stay as they are
};

/// The voxels of a case that lie between two opposite corners in the patient (LPS), whichever comes first.
VoxelBox boxBetween(const VolumeGeometry& geometry, Vec3 corner_mm, Vec3 opposite_mm);

/// The grid that cropCase makes. It fills the box: its border lies where the box's does, give or take half a new voxel.
/// Fails on an empty box, one beyond the grid, and a spacing that no scanner has.
Result<VolumeGeometry> croppedGrid(const VolumeGeometry& geometry, const CropOptions& options);

/// Crops a case, on the same or on another spacing: CT and labels together. A new voxel's HU is the mean of the
/// linearly interpolated CT over it, its label the one with the largest share of it, each label interpolated by itself
/// (so that a thin wall is not torn as by nearest voxels). Title, colors, targets and start poses stay, in patient
/// coordinates; targets outside are dropped. The import notes list the changes. Uses all cores. Same input: same
/// bytes, on any number of threads. Fails as croppedGrid does, and when cancelled.
Result<PatientCase> cropCase(const PatientCase& patient, const CropOptions& options, const Progress& progress = {});

}  // namespace insonate
