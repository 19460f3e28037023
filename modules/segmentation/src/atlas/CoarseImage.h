#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>
#include <insonate/image/VoxelBox.h>

#include <array>
#include <vector>

namespace insonate::segmentation {

/// Properties of tissue that a CT shows with and without contrast agent, each 0 to 1: gray value from fat to muscle
/// (brighter tissue counts as muscle, so that contrast agent has no effect), share of bone, of airway, and of the
/// space outside of the body.
using TissueValues = std::array<float, 4>;

/// A coarse image of a neck on a grid whose axes are the patient's axes.
struct CoarseImage {
  VolumeGeometry geometry;
  std::vector<TissueValues> values;
  std::vector<std::uint8_t> known;  ///< 0 at voxels beyond the CT, and in padding

  /// Returns the interpolated values at a continuous index. `isKnown` tells whether all voxels around it are known.
  TissueValues at(Vec3 index, bool& isKnown) const;
};

/// Returns the coarse image of a CT with automatic labels, in the box between two corners (patient space).
CoarseImage coarseImage(const CtVolume& ct, const LabelMap& automatic, Vec3 low_mm, Vec3 high_mm, double spacing_mm,
                        Work& work);

/// Returns the coarse image of labels without a CT. The axes of the grid of `labels` must be the patient's axes.
CoarseImage coarseImage(const LabelMap& labels, double spacing_mm);

/// Returns an image with twice the voxel size; each voxel is the mean of eight voxels.
CoarseImage halved(const CoarseImage& image);

/// Returns the image blurred with a Gaussian.
CoarseImage blurred(const CoarseImage& image, double sigma_mm);

}  // namespace insonate::segmentation
