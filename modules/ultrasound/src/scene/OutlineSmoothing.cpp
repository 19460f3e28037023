#include "scene/OutlineSmoothing.h"

#include "scene/RowFilters.h"

#include <algorithm>
#include <cmath>

namespace insonate {

OutlineSmoothing::Kernels OutlineSmoothing::gaussians(const NodeLattice& lattice, double factor) {
  Kernels kernels;
  for (int a = 0; a < 3; ++a) {
    const double sd = factor * lattice.smoothing_mm[a] / lattice.spacing_mm[a];
    const int radius = static_cast<int>(std::ceil(3 * sd));
    const auto weight = [sd](int o) { return std::exp(-0.5 * o * o / (sd * sd)); };
    double sum = 0;
    for (int o = -radius; o <= radius; ++o) sum += weight(o);
    for (int o = 0; o <= radius; ++o) kernels[a].push_back(static_cast<float>(weight(o) / sum));
  }
  return kernels;
}

OutlineSmoothing::Range OutlineSmoothing::inner(int axis, const Kernel& kernel) const {
  const int radius = static_cast<int>(kernel.size()) - 1;
  const int first = endsLow_[axis] ? 0 : radius, last = endsHigh_[axis] ? size_[axis] : size_[axis] - radius;
  return {first, std::max(first, last)};
}

/// Rows are padded on both sides, so that all rows of a slice are filtered in one pass.
void OutlineSmoothing::alongX(const Kernel& kernel, const float* in, float* out) {
  const std::size_t radius = kernel.size() - 1, nx = size_[0], ny = size_[1], stride = nx + 2 * radius;
  const Range x = inner(0, kernel);
  padded_.resize(ny * stride + 2 * radius);
  filtered_.resize(ny * stride);
  rows_.clear();
  for (std::size_t o = 0; o <= 2 * radius; ++o) rows_.push_back(padded_.data() + o);
  for (std::size_t j = 0; j < ny; ++j) {
    const float* row = in + j * nx;
    float* to = padded_.data() + j * stride;
    std::fill_n(to, radius, row[0]);
    std::copy_n(row, nx, to + radius);
    std::fill_n(to + radius + nx, radius, row[nx - 1]);
  }
  weighRows(rows_, kernel, filtered_);
  for (std::size_t j = 0; j < ny; ++j) {
    const float *row = in + j * nx, *from = filtered_.data() + j * stride;
    float* to = out + j * nx;
    std::copy(row, row + x.first, to);
    std::copy(from + x.first, from + x.last, to + x.first);
    std::copy(row + x.last, row + nx, to + x.last);
  }
}

void OutlineSmoothing::alongY(const Kernel& kernel, const float* in, float* out) {
  const int radius = static_cast<int>(kernel.size()) - 1, nx = size_[0], ny = size_[1];
  const Range y = inner(1, kernel);
  // Rows in the middle have no edges and are filtered together.
  const int first = std::clamp(radius, y.first, y.last), last = std::clamp(ny - radius, first, y.last);
  const auto filter = [&](int from, int to) {
    rows_.clear();
    for (int o = -radius; o <= radius; ++o) rows_.push_back(in + std::size_t(nx) * std::clamp(from + o, 0, ny - 1));
    weighRows(rows_, kernel, {out + std::size_t(nx) * from, std::size_t(nx) * (to - from)});
  };
  std::copy_n(in, std::size_t(nx) * y.first, out);
  for (int j = y.first; j < first; ++j) filter(j, j + 1);
  if (last > first) filter(first, last);
  for (int j = last; j < y.last; ++j) filter(j, j + 1);
  std::copy(in + std::size_t(nx) * y.last, in + std::size_t(nx) * ny, out + std::size_t(nx) * y.last);
}

/// Columns of rows that fit into the cache with all slices of the kernel.
void OutlineSmoothing::alongZ(const Kernel& kernel, const std::vector<float>& in, std::vector<float>& out) {
  constexpr std::size_t kPart = 2048;
  const int radius = static_cast<int>(kernel.size()) - 1;
  const std::size_t slice = std::size_t(size_[0]) * size_[1];
  const Range z = inner(2, kernel);
  for (std::size_t part = 0; part < slice; part += kPart) {
    const std::size_t width = std::min(kPart, slice - part);
    const auto copy = [&](int k) { std::copy_n(in.data() + slice * k + part, width, out.data() + slice * k + part); };
    for (int k = 0; k < z.first; ++k) copy(k);
    for (int k = z.first; k < z.last; ++k) {
      rows_.clear();
      for (int o = -radius; o <= radius; ++o)
        rows_.push_back(in.data() + slice * std::clamp(k + o, 0, size_[2] - 1) + part);
      weighRows(rows_, kernel, {out.data() + slice * k + part, width});
    }
    for (int k = z.last; k < size_[2]; ++k) copy(k);
  }
}

/// Slice by slice along x and y, since a slice fits into the cache.
void OutlineSmoothing::smooth(const Kernels& kernels, const std::vector<float>& in, std::vector<float>& out) {
  const std::size_t slice = std::size_t(size_[0]) * size_[1];
  slice_.resize(slice);
  planes_.resize(in.size());
  for (int k = 0; k < size_[2]; ++k) {
    alongX(kernels[0], in.data() + slice * k, slice_.data());
    alongY(kernels[1], slice_.data(), planes_.data() + slice * k);
  }
  alongZ(kernels[2], planes_, out);
}

/// Low-pass 2S - SS of a Gaussian S: it does not move outlines of low curvature, while S alone moves every vessel's
/// outline inward, by most of a voxel if the vessel is small (the idea of G. Taubin 1995).
void OutlineSmoothing::lowPass(const Kernels& kernels, std::vector<float>& d) {
  smooth(kernels, d, once_);
  smooth(kernels, once_, d);
  for (std::size_t n = 0; n < d.size(); ++n) d[n] = 2 * once_[n] - d[n];
}

void OutlineSmoothing::roundStairs(const NodeLattice& lattice, const NodeBox& block, const Stopped& stopped,
                                   std::vector<float>& d_mm) {
  constexpr int kRounds = 2;
  size_ = block.size;
  for (int a = 0; a < 3; ++a) endsLow_[a] = block.low[a] == 0, endsHigh_[a] = block.high(a) == lattice.size[a];
  once_.resize(d_mm.size());
  original_ = d_mm;
  const auto freedom_mm = static_cast<float>(lattice.freedom_mm);
  const Kernels kernels = gaussians(lattice, 1.3);
  for (int round = 0; round < kRounds; ++round) {
    if (stopped && stopped()) return;
    lowPass(kernels, d_mm);
    for (std::size_t n = 0; n < d_mm.size(); ++n)
      d_mm[n] = std::clamp(d_mm[n], original_[n] - freedom_mm, original_[n] + freedom_mm);
  }
  // The clamp causes new creases.
  lowPass(gaussians(lattice, 0.6), d_mm);
}

}  // namespace insonate
