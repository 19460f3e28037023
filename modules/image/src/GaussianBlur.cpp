#include <insonate/image/GaussianBlur.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace insonate {
namespace {

std::vector<float> gaussianKernel(double sigma_voxels) {
  const int reach = static_cast<int>(std::ceil(3 * sigma_voxels));
  std::vector<double> weights(2 * reach + 1);
  double sum = 0;
  for (int n = -reach; n <= reach; ++n)
    sum += weights[n + reach] = std::exp(-0.5 * n * n / std::max(1e-12, sigma_voxels * sigma_voxels));
  std::vector<float> kernel;
  for (const double w : weights) kernel.push_back(static_cast<float>(w / sum));
  return kernel;
}

/// One row through `line` (scratch with the row's edges repeated), elements `stride` apart.
void blurRow(float* row, std::size_t stride, int count, const std::vector<float>& kernel, std::vector<float>& line) {
  const int reach = static_cast<int>(kernel.size() / 2);
  line.resize(count + 2 * reach);
  for (int n = 0; n < count + 2 * reach; ++n) line[n] = row[std::clamp(n - reach, 0, count - 1) * stride];
  for (int n = 0; n < count; ++n) {
    float sum = 0;
    for (std::size_t m = 0; m < kernel.size(); ++m) sum += kernel[m] * line[n + m];
    row[n * stride] = sum;
  }
}

/// Blurs across the rows of a plane: `count` rows of `width` elements, `stride` apart, all columns together.
void blurAcross(float* plane, int width, std::size_t stride, int count, const std::vector<float>& kernel,
                std::vector<float>& copy) {
  const int reach = static_cast<int>(kernel.size() / 2);
  copy.resize(std::size_t(width) * count);
  for (int n = 0; n < count; ++n) std::copy_n(plane + n * stride, width, copy.data() + std::size_t(n) * width);
  for (int n = 0; n < count; ++n) {
    float* out = plane + n * stride;
    std::fill_n(out, width, 0.f);
    for (int m = -reach; m <= reach; ++m) {
      const float* in = copy.data() + std::size_t(std::clamp(n + m, 0, count - 1)) * width;
      const float weight = kernel[m + reach];
      for (int i = 0; i < width; ++i) out[i] += weight * in[i];
    }
  }
}

}  // namespace

void blurGaussian(Volume<float>& volume, double sigma_mm) {
  const VolumeGeometry& g = volume.geometry;
  const auto kernelAlong = [&](int axis) { return gaussianKernel(sigma_mm / g.spacing_mm[axis]); };
  const auto alongI = kernelAlong(0), alongJ = kernelAlong(1), alongK = kernelAlong(2);
  const std::size_t slice = std::size_t(g.size[0]) * g.size[1];
  tbb::parallel_for(0, g.size[2], [&](int k) {
    std::vector<float> scratch;
    for (int j = 0; j < g.size[1]; ++j) blurRow(&volume.at(0, j, k), 1, g.size[0], alongI, scratch);
    blurAcross(&volume.at(0, 0, k), g.size[0], g.size[0], g.size[1], alongJ, scratch);
  });
  tbb::parallel_for(0, g.size[1], [&](int j) {
    std::vector<float> scratch;
    blurAcross(&volume.at(0, j, 0), g.size[0], slice, g.size[2], alongK, scratch);
  });
}

}  // namespace insonate
