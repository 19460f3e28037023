#include "Calm.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace insonate::segmentation {
namespace {

constexpr int kApart = 3;            // voxels along a row, since a scanner's noise is correlated between neighbors
constexpr int kMaxDifference = 512;  // HU; larger differences across edges need no distinction
constexpr double kSdOfMedian = 1.4826;
constexpr double kSmall_mm = 0.8;  // about the width of the scanner's blur

/// Adds a row `weight` times.
void add(const std::int16_t* row, int weight, std::vector<int>& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * row[i];
}

}  // namespace

double noiseInBody_HU(const CtVolume& ct, const LabelMap& body, Work& work) {
  const auto [ni, nj, nk] = ct.geometry.size;
  using Counts = std::array<std::size_t, kMaxDifference + 1>;
  std::vector<Counts> perSlice(nk);
  work.slices(nk, [&, ni = ni, nj = nj](int k) {
    for (int j = 0; j < nj; ++j)
      for (int i = 0; i + kApart < ni; ++i)
        if (body.at(i, j, k) == kSoftTissue && body.at(i + kApart, j, k) == kSoftTissue)
          ++perSlice[k][std::min(std::abs(ct.at(i, j, k) - ct.at(i + kApart, j, k)), kMaxDifference)];
  });
  Counts counts{};
  for (const Counts& slice : perSlice) std::ranges::transform(counts, slice, counts.begin(), std::plus<>());
  std::size_t left = std::accumulate(counts.begin(), counts.end(), std::size_t{0}) / 2;
  int median = 0;
  while (median < kMaxDifference && left > counts[median]) left -= counts[median++];
  return kSdOfMedian * median / std::sqrt(2);
}

bool canBeCalmed(const VolumeGeometry& geometry) {
  const Vec3& s = geometry.spacing_mm;
  return (s.x <= kSmall_mm) + (s.y <= kSmall_mm) + (s.z <= kSmall_mm) >= 2;
}

CtVolume calmed(const CtVolume& ct, Work& work) {
  const auto [ni, nj, nk] = ct.geometry.size;
  const auto sideOf = [&](int axis) { return ct.geometry.spacing_mm[axis] <= kSmall_mm ? 1 : 0; };
  const int x = sideOf(0), y = sideOf(1), z = sideOf(2), whole = (2 + 2 * x) * (2 + 2 * y) * (2 + 2 * z);
  CtVolume calm(ct.geometry);
  work.slices(nk, [&, ni = ni, nj = nj, nk = nk](int k) {
    std::vector<int> sum(ni);
    for (int j = 0; j < nj; ++j) {
      std::ranges::fill(sum, 0);
      for (int dk = -z; dk <= z; ++dk)
        for (int dj = -y; dj <= y; ++dj)
          add(&ct.at(0, std::clamp(j + dj, 0, nj - 1), std::clamp(k + dk, 0, nk - 1)),
              (2 - std::abs(dk)) * (2 - std::abs(dj)), sum);
      std::int16_t* out = &calm.at(0, j, k);
      for (int i = 0; i < ni; ++i) {
        const int sides = x * (sum[std::max(i - 1, 0)] + sum[std::min(i + 1, ni - 1)]);
        out[i] = static_cast<std::int16_t>(std::lround(double(2 * sum[i] + sides) / whole));
      }
    }
  });
  return calm;
}

}  // namespace insonate::segmentation
