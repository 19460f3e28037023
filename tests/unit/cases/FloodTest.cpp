#include "CaseSamples.h"

#include <check/Flood.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <vector>

namespace insonate::check {
namespace {

using Index = std::array<int, 3>;

/// Two labels at random: many small parts where the first is rare, a sponge where it is not.
LabelMap noise(unsigned share) {
  LabelMap labels(test::grid({19, 17, 13}));
  for (std::size_t v = 0; v < labels.voxels.size(); ++v)
    labels.voxels[v] = hash32(std::uint32_t(v) * 31U + share) % 10 < share ? 1 : 2;
  return labels;
}

/// Voxels connected with the seeds, one voxel after the other.
std::vector<Index> grown(const LabelMap& labels, std::vector<Index> open, bool corners, std::vector<bool>& seen) {
  const VolumeGeometry& g = labels.geometry;
  std::vector<Index> all;
  while (!open.empty()) {
    const Index p = open.back();
    open.pop_back();
    if (!g.contains(p[0], p[1], p[2]) || labels.at(p[0], p[1], p[2]) != 1 || seen[g.offset(p[0], p[1], p[2])]) continue;
    seen[g.offset(p[0], p[1], p[2])] = true;
    all.push_back(p);
    for (int n = 0; n < 27; ++n) {
      const int i = n % 3 - 1, j = n / 3 % 3 - 1, k = n / 9 - 1;
      if (corners || std::abs(i) + std::abs(j) + std::abs(k) == 1) open.push_back({p[0] + i, p[1] + j, p[2] + k});
    }
  }
  return all;
}

void forVoxels(const VolumeGeometry& g, const std::function<void(const Index&)>& act) {
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) act({i, j, k});
}

TEST(Flood, ComesFromTheSidesAsFarAsFacesJoin) {
  for (const unsigned share : {1U, 3U, 5U, 8U})
    for (int endAxis = 0; endAxis < 3; ++endAxis) {
      const LabelMap labels = noise(share);
      const auto& size = labels.geometry.size;
      std::vector<Index> sides;
      forVoxels(labels.geometry, [&](const Index& p) {
        for (int a = 0; a < 3; ++a)
          if (a != endAxis && (p[a] == 0 || p[a] == size[a] - 1)) sides.push_back(p);
      });
      std::vector<bool> expected(labels.voxels.size());
      grown(labels, sides, false, expected);
      EXPECT_EQ(floodFromSides(labels, 1, endAxis), expected) << share << " " << endAxis;
    }
}

TEST(Flood, FindsPartsAndTheirEnds) {
  for (const unsigned share : {1U, 2U, 3U})
    for (int axis = 0; axis < 3; ++axis) {
      const LabelMap labels = noise(share);
      const Transform patientFromIndex = labels.geometry.patientFromIndex();
      std::vector<Part> expected;
      std::vector<bool> seen(labels.voxels.size());
      forVoxels(labels.geometry, [&](const Index& p) {
        const auto voxels = grown(labels, {p}, true, seen);
        if (voxels.empty()) return;
        const auto [low, high] = std::ranges::minmax(voxels, {}, [&](const Index& v) { return v[axis]; });
        const auto middleAt = [&](int at) {
          Vec3 sum;
          int count = 0;
          for (const Index& v : voxels)
            if (v[axis] == at) sum = sum + Vec3{double(v[0]), double(v[1]), double(v[2])}, ++count;
          return patientFromIndex * (sum / count);
        };
        expected.push_back({voxels.size(), low[axis], high[axis], middleAt(low[axis]), middleAt(high[axis])});
      });
      std::ranges::stable_sort(expected, std::greater{}, &Part::voxels);
      const auto parts = partsOf(labels, 1, axis);
      ASSERT_EQ(parts.size(), expected.size());
      for (std::size_t n = 0; n < parts.size(); ++n) {
        EXPECT_EQ(parts[n].voxels, expected[n].voxels);
        EXPECT_EQ(parts[n].low, expected[n].low);
        EXPECT_EQ(parts[n].high, expected[n].high);
        EXPECT_EQ(parts[n].lowEnd_mm, expected[n].lowEnd_mm);
        EXPECT_EQ(parts[n].highEnd_mm, expected[n].highEnd_mm);
      }
    }
}

TEST(Flood, MeasuresThePieceAtAPlace) {
  LabelMap labels(test::grid({9, 9, 9}));
  const Vec3 spacing_mm = labels.geometry.spacing_mm;
  // A stair that only corners join, and a voxel apart.
  for (int n = 1; n < 6; ++n) labels.at(n, n, n) = 1;
  labels.at(8, 1, 1) = 1;
  EXPECT_DOUBLE_EQ(pieceLength_mm(labels, {3, 3, 3}), 5 * std::max({spacing_mm.x, spacing_mm.y, spacing_mm.z}));
  EXPECT_DOUBLE_EQ(pieceLength_mm(labels, {8, 1, 1}), std::max({spacing_mm.x, spacing_mm.y, spacing_mm.z}));
  EXPECT_EQ(pieceLength_mm(labels, {-4, 0, 0}), 0);
}

}  // namespace
}  // namespace insonate::check
