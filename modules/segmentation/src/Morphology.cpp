#include "Morphology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace insonate::segmentation {
namespace {

/// Squared distances in units of the squared radius over kWithin, so that sums of two fit 16 bits and eight are
/// processed at once.
using Square = std::int16_t;
constexpr double kRadiusSquare = 16000;
constexpr Square kWithin = 16001;  // each of three distances is rounded, and a distance equal to the radius counts
constexpr Square kFar = kWithin + 1;

/// Squares of the distances of 0, 1, ... voxels up to the radius.
std::vector<Square> squares(double spacing_mm, double radius_mm) {
  std::vector<Square> squares{0};
  while (true) {
    const double share = double(squares.size()) * spacing_mm / radius_mm, square = kRadiusSquare * share * share;
    if (!(square < kWithin + 0.5)) return squares;
    squares.push_back(static_cast<Square>(std::lround(square)));
  }
}

/// Distances along a row to the nearest voxel of this value. False, and nothing written, if there is none.
bool squaresAlongRow(const std::uint8_t* row, std::uint8_t value, const std::vector<Square>& squares, Square* to,
                     int n) {
  if (std::find(row, row + n, value) == row + n) return false;
  const int far = static_cast<int>(squares.size());
  const auto squareOf = [&](int voxels) { return voxels < far ? squares[voxels] : kFar; };
  int d = far;
  for (int i = 0; i < n; ++i) {
    d = row[i] == value ? 0 : std::min(d + 1, far);
    to[i] = squareOf(d);
  }
  d = far;
  for (int i = n - 1; i >= 0; --i) {
    d = row[i] == value ? 0 : std::min(d + 1, far);
    to[i] = std::min(to[i], squareOf(d));
  }
  return true;
}

/// Distances in one slice to the nearest voxel of this value. False, and nothing written, if there is none.
bool squaresInSlice(const Mask& mask, int k, std::uint8_t value, const std::array<std::vector<Square>, 3>& along,
                    Square* to) {
  const auto [ni, nj, nk] = mask.geometry.size;
  std::vector<Square> rows(std::size_t(ni) * nj);
  std::vector<bool> rowHasAny(nj);
  for (int j = 0; j < nj; ++j)
    rowHasAny[j] = squaresAlongRow(&mask.at(0, j, k), value, along[0], &rows[std::size_t(j) * ni], ni);
  if (std::find(rowHasAny.begin(), rowHasAny.end(), true) == rowHasAny.end()) return false;
  const int reach = static_cast<int>(along[1].size()) - 1;
  for (int j = 0; j < nj; ++j) {
    Square* out = to + std::size_t(j) * ni;
    std::fill(out, out + ni, kFar);
    for (int y = std::max(0, j - reach); y <= std::min(nj - 1, j + reach); ++y) {
      if (!rowHasAny[y]) continue;
      const Square* in = &rows[std::size_t(y) * ni];
      const Square aside = along[1][std::abs(y - j)];
      for (int i = 0; i < ni; ++i) out[i] = std::min(out[i], static_cast<Square>(in[i] + aside));
    }
  }
  return true;
}

/// Sets the voxels within the radius of one of this value to the value: first the distances in each slice, then between
/// slices. Only the slices within the radius are in memory.
void spread(Mask& mask, std::uint8_t value, double radius_mm, Work& work) {
  const auto [ni, nj, nk] = mask.geometry.size;
  std::array<std::vector<Square>, 3> along;
  for (int axis = 0; axis < 3; ++axis) along[axis] = squares(mask.geometry.spacing_mm[axis], radius_mm);
  constexpr int kBatch = 32;
  const int reach = static_cast<int>(std::min<std::size_t>(along[2].size() - 1, nk)), held = 2 * reach + kBatch;
  const std::size_t voxels = std::size_t(ni) * nj;
  std::vector<Square> slices(std::min(held, nk) * voxels);
  const auto sliceOf = [&](int k) { return &slices[std::size_t(k % held) * voxels]; };
  std::vector<std::uint8_t> hasAny(nk);
  int measured = 0;
  for (int begin = 0; begin < nk; begin += kBatch) {
    const int end = std::min<int>(nk, begin + kBatch), seen = std::min<int>(nk, end + reach);
    work.part(measured, seen, nk, [&](int k) { hasAny[k] = squaresInSlice(mask, k, value, along, sliceOf(k)); });
    measured = seen;
    work.part(begin, end, nk, [&, nk = nk](int k) {
      std::uint8_t* out = &mask.at(0, 0, k);
      for (int z = std::max(0, k - reach); z <= std::min(nk - 1, k + reach); ++z) {
        if (!hasAny[z]) continue;
        const Square* in = sliceOf(z);
        const auto within = static_cast<Square>(kWithin - along[2][std::abs(z - k)]);
        for (std::size_t v = 0; v < voxels; ++v) out[v] = in[v] <= within ? value : out[v];
      }
    });
  }
}

}  // namespace

void dilate(Mask& mask, double radius_mm, Work& work) {
  spread(mask, 1, radius_mm, work);
}

void erode(Mask& mask, double radius_mm, Work& work) {
  spread(mask, 0, radius_mm, work);
}

void open(Mask& mask, double radius_mm, Work& work) {
  erode(mask, radius_mm, work);
  dilate(mask, radius_mm, work);
}

void close(Mask& mask, double radius_mm, Work& work) {
  dilate(mask, radius_mm, work);
  erode(mask, radius_mm, work);
}

void dilateToNeighbors(Mask& mask, Work& work) {
  const auto [ni, nj, nk] = mask.geometry.size;
  const Mask before = mask;
  work.slices(nk, [&, ni = ni, nj = nj, nk = nk](int k) {
    for (int j = 0; j < nj; ++j) {
      std::uint8_t* out = &mask.at(0, j, k);
      const auto add = [&](int y, int z) {
        if (y < 0 || z < 0 || y >= nj || z >= nk) return;
        const std::uint8_t* in = &before.at(0, y, z);
        for (int i = 0; i < ni; ++i) out[i] |= in[i];
      };
      add(j - 1, k), add(j + 1, k), add(j, k - 1), add(j, k + 1);
      const std::uint8_t* row = &before.at(0, j, k);
      for (int i = 1; i < ni; ++i) out[i] |= row[i - 1], out[i - 1] |= row[i];
    }
  });
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
