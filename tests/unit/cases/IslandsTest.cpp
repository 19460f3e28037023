#include "CaseSamples.h"

#include <check/Islands.h>
#include <gtest/gtest.h>

#include <map>
#include <queue>

namespace insonate::check {
namespace {

/// Sizes of what hangs together, counted the slow way.
std::multimap<int, std::size_t> counted(const LabelMap& labels, Joining joining) {
  const VolumeGeometry& g = labels.geometry;
  std::vector<char> seen(labels.voxels.size());
  std::multimap<int, std::size_t> sizes;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const std::uint8_t label = labels.at(i, j, k);
        if (!label || seen[g.offset(i, j, k)]) continue;
        std::queue<std::array<int, 3>> open;
        open.push({i, j, k});
        seen[g.offset(i, j, k)] = 1;
        std::size_t n = 0;
        for (; !open.empty(); ++n) {
          const auto p = open.front();
          open.pop();
          for (int a = 0; a < 6; ++a) {
            auto q = p;
            q[std::size_t(a / 2)] += a % 2 ? 1 : -1;
            if (!g.contains(q[0], q[1], q[2]) || seen[g.offset(q[0], q[1], q[2])]) continue;
            const std::uint8_t other = labels.at(q[0], q[1], q[2]);
            if (joining == Joining::kOneLabel ? other != label : other == 0) continue;
            seen[g.offset(q[0], q[1], q[2])] = 1;
            open.push(q);
          }
        }
        sizes.emplace(label, n);
      }
  return sizes;
}

TEST(Islands, AreThoseOfASlowCountOnNoise) {
  LabelMap labels(test::grid({23, 19, 17}));
  for (const int density : {1, 2, 3, 4}) {
    for (std::size_t v = 0; v < labels.voxels.size(); ++v)
      labels.voxels[v] = std::uint8_t(hash32(std::uint32_t(v) * 31U + std::uint32_t(density)) % 5 < unsigned(density)
                                          ? 1 + hash32(std::uint32_t(v)) % 2
                                          : 0);
    for (const Joining joining : {Joining::kOneLabel, Joining::kAnyLabel}) {
      std::multimap<int, std::size_t> found;
      for (const Island& island : islandsOf(labels, joining)) found.emplace(island.label, island.voxels);
      std::multimap<std::size_t, int> a, b;
      for (const auto& [label, n] : found) a.emplace(n, label);
      for (const auto& [label, n] : counted(labels, joining)) b.emplace(n, label);
      ASSERT_EQ(a.size(), b.size()) << density;
      for (auto x = a.begin(), y = b.begin(); x != a.end(); ++x, ++y) EXPECT_EQ(x->first, y->first);
    }
  }
}

TEST(Islands, EmptyMapHasNone) {
  EXPECT_TRUE(islandsOf(LabelMap(test::grid({3, 3, 3})), Joining::kAnyLabel).empty());
}

}  // namespace
}  // namespace insonate::check
