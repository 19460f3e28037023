// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "elastic/FrontKernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target:
#include "elastic/FrontKernel.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::elastic::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 16>;

/// target[i][j] -= sum over r of a[r][i] * b[r][j] for a tile of kRows x (2 vectors).
template <int kRows>
HWY_INLINE void subtractTile(const float* HWY_RESTRICT a, const float* HWY_RESTRICT b, int stride, int depth,
                             float* HWY_RESTRICT target, int targetStride) {
  const Tag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  using V = hn::Vec<Tag>;
  V low[kRows], high[kRows];
  for (int i = 0; i < kRows; ++i) low[i] = high[i] = hn::Zero(d);
  for (int r = 0; r < depth; ++r) {
    const V b0 = hn::LoadU(d, b), b1 = hn::LoadU(d, b + lanes);
    for (int i = 0; i < kRows; ++i) {
      const V s = hn::Set(d, a[i]);
      low[i] = hn::MulAdd(s, b0, low[i]);
      high[i] = hn::MulAdd(s, b1, high[i]);
    }
    a += stride;
    b += stride;
  }
  for (int i = 0; i < kRows; ++i) {
    float* t = target + i * targetStride;
    hn::StoreU(hn::Sub(hn::LoadU(d, t), low[i]), d, t);
    hn::StoreU(hn::Sub(hn::LoadU(d, t + lanes), high[i]), d, t + lanes);
  }
}

/// The upper triangle of target -= panel^T panel, `size` rows and columns. Writes below the diagonal and up to two
/// vectors beyond the last column.
void subtractSquare(const float* panel, int stride, int depth, float* target, int targetStride, int size) {
  const int width = 2 * static_cast<int>(hn::Lanes(Tag()));
  int i = 0;
  for (; i + 8 <= size; i += 8)
    for (int j = i; j < size; j += width)
      subtractTile<8>(panel + i, panel + j, stride, depth, target + i * targetStride + j, targetStride);
  for (; i + 2 <= size; i += 2)
    for (int j = i; j < size; j += width)
      subtractTile<2>(panel + i, panel + j, stride, depth, target + i * targetStride + j, targetStride);
}

/// row -= factor * other, from `begin`.
HWY_INLINE void subtractRow(float* HWY_RESTRICT row, const float* HWY_RESTRICT other, float factor, int begin,
                            int end) {
  const Tag d;
  const auto f = hn::Set(d, factor);
  for (int j = begin; j < end; j += static_cast<int>(hn::Lanes(d)))
    hn::StoreU(hn::NegMulAdd(f, hn::LoadU(d, other + j), hn::LoadU(d, row + j)), d, row + j);
}

HWY_INLINE void addRow(float* HWY_RESTRICT to, const float* HWY_RESTRICT from, int count) {
  const Tag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int j = 0;
  for (; j + lanes <= count; j += lanes) hn::StoreU(hn::Add(hn::LoadU(d, to + j), hn::LoadU(d, from + j)), d, to + j);
  for (; j < count; ++j) to[j] += from[j];
}

void addChild(const FrontWork& work, const GridOrder::Front& parent, const GridOrder::Front& child, float* panel,
              float* update) {
  const GridOrder::Run* runs = work.order.runs().data() + child.firstRun;
  const float* from = work.updates[child.side][child.depth].data();
  for (int a = 0; a < child.runs; ++a)
    for (int r = 0; r < runs[a].count; ++r) {
      const int row = runs[a].to + r;
      float* to = row < parent.own ? panel + std::size_t(row) * parent.stride
                                   : update + std::size_t(row - parent.own) * parent.stride - parent.own;
      const float* source = from + std::size_t(runs[a].from + r) * child.stride;
      addRow(to + row, source + runs[a].from + r, runs[a].count - r);
      for (int b = a + 1; b < child.runs; ++b) addRow(to + runs[b].to, source + runs[b].from, runs[b].count);
    }
}

void addEntries(const FrontWork& work, const GridOrder::Front& front, float* panel) {
  const auto& value = work.matrix.value;
  const GridOrder::Entry* entry = work.order.entries().data() + front.firstEntry;
  for (int e = 0; e < front.entries; ++e, ++entry) {
    float* at = panel + entry->at;
    const int n = entry->node;
    if (entry->block == GridMatrix::Self) {
      at[0] += value[0][n];
      at[1] += value[1][n];
      at[front.stride + 1] += value[2][n];
      continue;
    }
    const auto* v = &value[GridMatrix::first(entry->block)];
    const int xz = entry->transposed ? 2 : 1;
    at[0] += v[0][n];
    at[1] += v[xz][n];
    at[front.stride] += v[3 - xz][n];
    at[front.stride + 1] += v[3][n];
  }
}

int factorPanel(float* panel, int own, int size, int stride) {
  constexpr int kBlock = 16;
  int notPositive = 0;
  for (int begin = 0; begin < own; begin += kBlock) {
    const int end = std::min(begin + kBlock, own);
    for (int r = begin; r < end; ++r) {
      float* row = panel + std::size_t(r) * stride;
      for (int s = begin; s < r; ++s) {
        const float* other = panel + std::size_t(s) * stride;
        subtractRow(row, other, other[r], r, size);
      }
      float inverse = 0;
      if (row[r] > 1e-12f)
        inverse = 1 / std::sqrt(row[r]);
      else
        ++notPositive;
      const Tag d;
      const auto f = hn::Set(d, inverse);
      for (int j = r; j < size; j += static_cast<int>(hn::Lanes(d)))
        hn::StoreU(hn::Mul(hn::LoadU(d, row + j), f), d, row + j);
      row[r] = inverse;  // of the diagonal: what substitution needs
    }
    if (end == own) break;
    // The rest of the panel's own rows; the border's columns come along.
    const int width = 2 * static_cast<int>(hn::Lanes(Tag()));
    const float* block = panel + std::size_t(begin) * stride;
    int i = end;
    for (; i + 8 <= own; i += 8)
      for (int j = i; j < size; j += width)
        subtractTile<8>(block + i, block + j, stride, end - begin, panel + std::size_t(i) * stride + j, stride);
    for (; i + 2 <= own; i += 2)
      for (int j = i; j < size; j += width)
        subtractTile<2>(block + i, block + j, stride, end - begin, panel + std::size_t(i) * stride + j, stride);
  }
  return notPositive;
}

int eliminateTarget(const FrontWork& work, int index) {
  const GridOrder::Front& front = work.order.fronts()[index];
  float* panel = work.panels + front.panel;
  float* update = work.updates[front.side][front.depth].data();
  std::fill_n(panel, std::size_t(front.own) * front.stride, 0.0f);
  std::fill_n(update, std::size_t(front.border) * front.stride, 0.0f);
  addEntries(work, front, panel);
  for (const int child : front.child)
    if (child >= 0) addChild(work, front, work.order.fronts()[child], panel, update);
  const int notPositive = factorPanel(panel, front.own, front.own + front.border, front.stride);
  subtractSquare(panel + front.own, front.stride, front.own, update, front.stride, front.border);
  return notPositive;
}

void substituteTarget(const GridOrder& order, const float* panels, float* x, float* border) {
  const Tag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto& fronts = order.fronts();
  for (const GridOrder::Front& front : fronts) {
    const int* places = order.borderUnknowns().data() + front.firstBorder;
    const int size = front.own + front.border;
    std::copy_n(x + front.first, front.own, border);
    for (int b = 0; b < front.border; ++b) border[front.own + b] = x[places[b]];
    for (int r = 0; r < front.own; ++r) {
      const float* row = panels + front.panel + std::size_t(r) * front.stride;
      const float y = border[r] * row[r];
      x[front.first + r] = y;
      subtractRow(border, row, y, r + 1, size);
    }
    for (int b = 0; b < front.border; ++b) x[places[b]] = border[front.own + b];
  }
  for (auto front = fronts.rbegin(); front != fronts.rend(); ++front) {
    const int* places = order.borderUnknowns().data() + front->firstBorder;
    const int size = front->own + front->border;
    std::copy_n(x + front->first, front->own, border);
    for (int b = 0; b < front->border; ++b) border[front->own + b] = x[places[b]];
    std::fill_n(border + size, 32, 0.0f);
    for (int r = front->own - 1; r >= 0; --r) {
      const float* row = panels + front->panel + std::size_t(r) * front->stride;
      auto sum = hn::Zero(d);
      for (int j = r + 1; j < size; j += lanes) sum = hn::MulAdd(hn::LoadU(d, row + j), hn::LoadU(d, border + j), sum);
      border[r] = (border[r] - hn::GetLane(hn::SumOfLanes(d, sum))) * row[r];
    }
    std::copy_n(border, front->own, x + front->first);
  }
}

}  // namespace insonate::elastic::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::elastic {
HWY_EXPORT(eliminateTarget);
HWY_EXPORT(substituteTarget);

int eliminateFront(const FrontWork& work, int front) {
  return HWY_DYNAMIC_DISPATCH(eliminateTarget)(work, front);
}

void substitute(const GridOrder& order, const float* panels, float* x, float* border) {
  HWY_DYNAMIC_DISPATCH(substituteTarget)(order, panels, x, border);
}

}  // namespace insonate::elastic
#endif
