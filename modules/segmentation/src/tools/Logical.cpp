#include <insonate/segmentation/Logical.h>

namespace insonate {

Selection combined(const Selection& a, LogicalOperation operation, const Selection& b, const VolumeGeometry& geometry) {
  Selection result(geometry, operation == LogicalOperation::kAdd ? united(a.box, b.box) : a.box);
  const VoxelBox& box = result.box;
  std::uint8_t* out = result.mask.voxels.data();
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i, ++out) {
        const bool inA = a.isSelected(i, j, k), inB = b.isSelected(i, j, k);
        *out = operation == LogicalOperation::kAdd        ? inA || inB
               : operation == LogicalOperation::kSubtract ? inA && !inB
                                                          : inA && inB;
      }
  return result;
}

Selection inverted(Selection selection) {
  for (std::uint8_t& voxel : selection.mask.voxels) voxel ^= 1;
  return selection;
}

}  // namespace insonate
