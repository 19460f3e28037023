#include "BlockCount.h"

#include <array>
#include <cstdint>
#include <vector>

namespace insonate::segmentation {
namespace {

using Counts = Volume<std::uint32_t>;

/// Replaces each number of a line, `stride` apart, by the sum over `reach` on both sides.
void sumAlong(std::uint32_t* line, std::size_t stride, int count, int reach, std::vector<std::uint32_t>& sums) {
  sums.resize(count + 1);
  sums[0] = 0;
  for (int n = 0; n < count; ++n) sums[n + 1] = sums[n] + line[n * stride];
  for (int n = 0; n < count; ++n)
    line[n * stride] = sums[std::min(count, n + reach + 1)] - sums[std::max(0, n - reach)];
}

}  // namespace

void majorityInBlock(Mask& mask, double radius_mm, Work& work) {
  const VolumeGeometry& g = mask.geometry;
  const auto [ni, nj, nk] = g.size;
  std::array<int, 3> reach{};
  for (int axis = 0; axis < 3; ++axis)
    reach[axis] = static_cast<int>(std::min(radius_mm / g.spacing_mm[axis], double(g.size[axis])));
  Counts counts(g);
  work.slices(nk, [&, ni = ni, nj = nj](int k) {
    std::vector<std::uint32_t> sums;
    std::copy_n(&mask.at(0, 0, k), std::size_t(ni) * nj, &counts.at(0, 0, k));
    for (int j = 0; j < nj; ++j) sumAlong(&counts.at(0, j, k), 1, ni, reach[0], sums);
    for (int i = 0; i < ni; ++i) sumAlong(&counts.at(i, 0, k), ni, nj, reach[1], sums);
  });
  work.slices(nj, [&, ni = ni, nj = nj, nk = nk](int j) {
    std::vector<std::uint32_t> sums;
    for (int i = 0; i < ni; ++i) sumAlong(&counts.at(i, j, 0), std::size_t(ni) * nj, nk, reach[2], sums);
  });
  const auto width = [&](int axis, int at) {
    return std::uint32_t(std::min(g.size[axis], at + reach[axis] + 1) - std::max(0, at - reach[axis]));
  };
  work.slices(nk, [&, ni = ni, nj = nj](int k) {
    for (int j = 0; j < nj; ++j) {
      const std::uint32_t rows = width(1, j) * width(2, k);
      for (int i = 0; i < ni; ++i) mask.at(i, j, k) = 2 * counts.at(i, j, k) > rows * width(0, i);
    }
  });
}

}  // namespace insonate::segmentation
