// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "elastic/FrontKernel.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target:
#include "elastic/FrontKernel.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::elastic::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 16>;
constexpr int kOverhang = 16;
/// A zero unknown to the compiler: an image clears forty thousand rows of about ten numbers, and as many calls of
/// memset would be slower.
volatile const float kNothing = 0;

/// target[i][j] -= sum over r of a[r][i] * b[r][j] for a tile of kRows x kVectors vectors.
template <int kRows, int kVectors>
HWY_INLINE void subtractTile(const float* HWY_RESTRICT a, const float* HWY_RESTRICT b, int stride, int depth,
                             float* HWY_RESTRICT target) {
  const Tag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  using V = hn::Vec<Tag>;
  V sum[kRows][kVectors];
  for (auto& row : sum)
    for (V& v : row) v = hn::Zero(d);
  for (int r = 0; r < depth; ++r) {
    V bv[kVectors];
    for (int v = 0; v < kVectors; ++v) bv[v] = hn::LoadU(d, b + v * lanes);
    for (int i = 0; i < kRows; ++i) {
      const V s = hn::Set(d, a[i]);
      for (int v = 0; v < kVectors; ++v) sum[i][v] = hn::MulAdd(s, bv[v], sum[i][v]);
    }
    a += stride;
    b += stride;
  }
  for (int i = 0; i < kRows; ++i)
    for (int v = 0; v < kVectors; ++v) {
      float* t = target + i * stride + v * lanes;
      hn::StoreU(hn::Sub(hn::LoadU(d, t), sum[i][v]), d, t);
    }
}

/// The same for columns `begin` to `end`; writes up to one vector beyond.
template <int kRows>
HWY_INLINE void subtractRows(const float* a, const float* b, int stride, int depth, float* target, int begin, int end) {
  const int lanes = static_cast<int>(hn::Lanes(Tag()));
  int j = begin;
  for (; j + lanes < end; j += 2 * lanes) subtractTile<kRows, 2>(a, b + j, stride, depth, target + j);
  if (j < end) subtractTile<kRows, 1>(a, b + j, stride, depth, target + j);
}

/// target[i][j] -= sum over r of panel[r][i] * panel[r][j] for rows `first` to `last` (even in number) and columns from
/// the diagonal to `end`. Writes below the diagonal, too.
void subtractSquare(const float* panel, int stride, int depth, float* target, int first, int last, int end) {
  int i = first;
  for (; i + 8 <= last; i += 8)
    subtractRows<8>(panel + i, panel, stride, depth, target + std::size_t(i) * stride, i, end);
  for (; i + 2 <= last; i += 2)
    subtractRows<2>(panel + i, panel, stride, depth, target + std::size_t(i) * stride, i, end);
}

/// row -= factor * other, from `begin`.
HWY_INLINE void subtractRow(float* HWY_RESTRICT row, const float* HWY_RESTRICT other, float factor, int begin,
                            int end) {
  const Tag d;
  const auto f = hn::Set(d, factor);
  for (int j = begin; j < end; j += static_cast<int>(hn::Lanes(d)))
    hn::StoreU(hn::NegMulAdd(f, hn::LoadU(d, other + j), hn::LoadU(d, row + j)), d, row + j);
}

/// Columns `begin` to `end`, and up to one vector beyond.
HWY_INLINE void clearRow(hn::Vec<Tag> nothing, float* HWY_RESTRICT row, int begin, int end) {
  const Tag d;
  for (int j = begin; j < end; j += static_cast<int>(hn::Lanes(d))) hn::StoreU(nothing, d, row + j);
}

HWY_INLINE void addRow(float* HWY_RESTRICT to, const float* HWY_RESTRICT from, int count) {
  const Tag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int j = 0;
  for (; j + lanes <= count; j += lanes) hn::StoreU(hn::Add(hn::LoadU(d, to + j), hn::LoadU(d, from + j)), d, to + j);
  if (j == count) return;
  const auto rest = hn::FirstN(d, count - j);
  const auto sum = hn::Add(hn::MaskedLoad(rest, d, to + j), hn::MaskedLoad(rest, d, from + j));
  hn::BlendedStore(sum, rest, d, to + j);
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
      to[parent.own + parent.border] += source[child.border];
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
  constexpr int kBlock = 8;
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
      row[r] = inverse;  // inverse of the diagonal, for substitution
    }
    subtractSquare(panel + std::size_t(begin) * stride, stride, end - begin, panel, end, own, size);
  }
  return notPositive;
}

int eliminateTarget(const FrontWork& work, int index) {
  const GridOrder::Front& front = work.order.fronts()[index];
  float* panel = work.panels + front.panel;
  float* update = work.updates[front.side][front.depth].data();
  const int size = front.own + front.border;
  const auto nothing = hn::Set(Tag(), kNothing);
  // Initializes the part that whole vectors write: substitution multiplies it by zero, so that it must not be infinite.
  for (int r = 0; r < front.own; ++r) clearRow(nothing, panel + std::size_t(r) * front.stride, r, size + kOverhang);
  for (int r = 0; r < front.border; ++r) clearRow(nothing, update + std::size_t(r) * front.stride, r, front.border + 1);
  addEntries(work, front, panel);
  for (int r = 0; r < front.own; ++r) panel[std::size_t(r) * front.stride + size] = work.right[front.first + r];
  for (const int child : front.child)
    if (child >= 0) addChild(work, front, work.order.fronts()[child], panel, update);
  const int notPositive = factorPanel(panel, front.own, size + 1, front.stride);
  for (int r = 0; r < front.own; ++r) work.right[front.first + r] = panel[std::size_t(r) * front.stride + size];
  subtractSquare(panel + front.own, front.stride, front.own, update, 0, front.border, front.border + 1);
  return notPositive;
}

void forwardTarget(const GridOrder& order, const float* panels, float* x, float* border) {
  for (const GridOrder::Front& front : order.fronts()) {
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
}

void backwardTarget(const GridOrder& order, const float* panels, float* x, float* border) {
  const Tag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto& fronts = order.fronts();
  for (auto front = fronts.rbegin(); front != fronts.rend(); ++front) {
    const int* places = order.borderUnknowns().data() + front->firstBorder;
    const int size = front->own + front->border;
    std::copy_n(x + front->first, front->own, border);
    for (int b = 0; b < front->border; ++b) border[front->own + b] = x[places[b]];
    std::fill_n(border + size, lanes, 0.0f);
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
HWY_EXPORT(forwardTarget);
HWY_EXPORT(backwardTarget);

int eliminateFront(const FrontWork& work, int front) {
  return HWY_DYNAMIC_DISPATCH(eliminateTarget)(work, front);
}

void substituteForward(const GridOrder& order, const float* panels, float* x, float* border) {
  HWY_DYNAMIC_DISPATCH(forwardTarget)(order, panels, x, border);
}

void substituteBackward(const GridOrder& order, const float* panels, float* x, float* border) {
  HWY_DYNAMIC_DISPATCH(backwardTarget)(order, panels, x, border);
}

}  // namespace insonate::elastic
#endif
