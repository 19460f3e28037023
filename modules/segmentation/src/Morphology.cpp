#include "Morphology.h"

#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr int kFar = 255;

/// A row of the ball: offset in j and k, and how far the ball reaches along i, in voxels.
struct Chord {
  int j, k;
  std::uint8_t reach;
};

std::vector<Chord> ball(const Vec3& spacing_mm, double radius_mm) {
  std::vector<Chord> chords;
  const int nj = static_cast<int>(radius_mm / spacing_mm.y), nk = static_cast<int>(radius_mm / spacing_mm.z);
  for (int k = -nk; k <= nk; ++k)
    for (int j = -nj; j <= nj; ++j) {
      const double y = j * spacing_mm.y, z = k * spacing_mm.z;
      const double left = radius_mm * radius_mm - y * y - z * z;
      if (left < 0) continue;
      chords.push_back({j, k, static_cast<std::uint8_t>(std::min(std::sqrt(left) / spacing_mm.x, kFar - 1.0))});
    }
  return chords;
}

/// Voxels along the row to the nearest set voxel, at most kFar. False, and nothing written, when none is set.
bool distancesAlongRow(const std::uint8_t* set, std::uint8_t* distance, int n) {
  if (std::find(set, set + n, 1) == set + n) return false;
  int d = kFar;
  for (int i = 0; i < n; ++i) {
    d = set[i] ? 0 : std::min(d + 1, kFar);
    distance[i] = static_cast<std::uint8_t>(d);
  }
  d = kFar;
  for (int i = n - 1; i >= 0; --i) {
    d = std::min<int>(d + 1, distance[i]);
    distance[i] = static_cast<std::uint8_t>(d);
  }
  return true;
}

void dilateWith(Mask& mask, const std::vector<Chord>& chords, Work& work) {
  const auto [ni, nj, nk] = mask.geometry.size;
  Mask distance(mask.geometry);
  std::vector<std::uint8_t> rowHasAny(std::size_t(nj) * nk);
  work.slices(nk, [&, ni = ni, nj = nj](int k) {
    for (int j = 0; j < nj; ++j)
      rowHasAny[std::size_t(k) * nj + j] = distancesAlongRow(&mask.at(0, j, k), &distance.at(0, j, k), ni);
  });
  work.slices(nk, [&, ni = ni, nj = nj, nk = nk](int k) {
    for (int j = 0; j < nj; ++j) {
      std::uint8_t* out = &mask.at(0, j, k);
      for (const Chord& chord : chords) {
        const int y = j + chord.j, z = k + chord.k;
        if (y < 0 || z < 0 || y >= nj || z >= nk || !rowHasAny[std::size_t(z) * nj + y]) continue;
        const std::uint8_t* in = &distance.at(0, y, z);
        for (int i = 0; i < ni; ++i) out[i] |= static_cast<std::uint8_t>(in[i] <= chord.reach);
      }
    }
  });
}

void complement(Mask& mask, Work& work) {
  work.voxels(mask.geometry, [&](std::size_t v) { mask.voxels[v] ^= 1; });
}

}  // namespace

void dilate(Mask& mask, double radius_mm, Work& work) {
  dilateWith(mask, ball(mask.geometry.spacing_mm, radius_mm), work);
}

void erode(Mask& mask, double radius_mm, Work& work) {
  complement(mask, work);
  dilate(mask, radius_mm, work);
  complement(mask, work);
}

void open(Mask& mask, double radius_mm, Work& work) {
  erode(mask, radius_mm, work);
  dilate(mask, radius_mm, work);
}

void close(Mask& mask, double radius_mm, Work& work) {
  dilate(mask, radius_mm, work);
  erode(mask, radius_mm, work);
}

void dilateToNeighbours(Mask& mask, Work& work) {
  dilateWith(mask, {{0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}}, work);
}

void majorityInSlice(Mask& mask, Work& work) {
  const auto [ni, nj, nk] = mask.geometry.size;
  if (ni < 3 || nj < 3) return;
  work.slices(nk, [&, ni = ni, nj = nj](int k) {
    const std::size_t slice = std::size_t(ni) * nj;
    const std::uint8_t* first = mask.voxels.data() + k * slice;
    const std::vector<std::uint8_t> before(first, first + slice);
    for (int j = 1; j + 1 < nj; ++j) {
      std::uint8_t* out = &mask.at(0, j, k);
      const std::uint8_t *a = &before[std::size_t(j - 1) * ni], *b = a + ni, *c = b + ni;
      for (int i = 1; i + 1 < ni; ++i) {
        const int sum = a[i - 1] + a[i] + a[i + 1] + b[i - 1] + b[i] + b[i + 1] + c[i - 1] + c[i] + c[i + 1];
        out[i] = static_cast<std::uint8_t>(sum >= 5);
      }
    }
  });
}

}  // namespace insonate::segmentation
