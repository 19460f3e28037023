#include "Gradient.h"

#include <insonate/image/GaussianBlur.h>

#include <array>
#include <cmath>

namespace insonate::segmentation {

Volume<float> blurred(const CtVolume& ct, const VoxelBox& box, double sigma_mm) {
  const CtVolume part = cropped(ct, box);
  Volume<float> smooth;
  smooth.geometry = part.geometry;
  smooth.voxels.assign(part.voxels.begin(), part.voxels.end());
  if (sigma_mm > 0) blurGaussian(smooth, sigma_mm);
  return smooth;
}

Volume<float> gradientMagnitude(const CtVolume& ct, const VoxelBox& box, double sigma_mm, Work& work) {
  const Volume<float> hu = blurred(ct, box, sigma_mm);
  const VolumeGeometry& g = hu.geometry;
  const std::array<std::size_t, 3> stride{1, std::size_t(g.size[0]), std::size_t(g.size[0]) * g.size[1]};
  Volume<float> magnitude(g);
  work.slices(g.size[2], [&](int k) {
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const std::array at{i, j, k};
        const std::size_t v = g.offset(i, j, k);
        double squares = 0;
        for (int axis = 0; axis < 3; ++axis) {
          const std::size_t back = at[axis] > 0 ? stride[axis] : 0;
          const std::size_t on = at[axis] + 1 < g.size[axis] ? stride[axis] : 0;
          if (back + on == 0) continue;
          const double width_mm = g.spacing_mm[axis] * (back && on ? 2 : 1);
          const double slope = (hu.voxels[v + on] - hu.voxels[v - back]) / width_mm;
          squares += slope * slope;
        }
        magnitude.voxels[v] = static_cast<float>(std::sqrt(squares));
      }
  });
  return magnitude;
}

}  // namespace insonate::segmentation
