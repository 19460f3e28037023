// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/RowFilters.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target:
#include "scene/RowFilters.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace insonate::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Runs `part(tag, i)` over a row from `i` on: whole vectors first, then one by one.
template <class Part>
HWY_INLINE void alongRow(std::size_t i, std::size_t size, const Part& part) {
  const hn::ScalableTag<float> wide;
  const hn::CappedTag<float, 1> single;
  for (; i + hn::Lanes(wide) <= size; i += hn::Lanes(wide)) part(wide, i);
  for (; i < size; ++i) part(single, i);
}

void weighRowsTarget(std::span<const float* const> rows, std::span<const float> weight, std::span<float> out) {
  const std::size_t radius = weight.size() - 1;
  const hn::ScalableTag<float> wide;
  const std::size_t lanes = hn::Lanes(wide), four = out.size() / (4 * lanes) * (4 * lanes);
  // Four vectors at a time, so that none waits for its own sum.
  for (std::size_t i = 0; i < four; i += 4 * lanes) {
    const auto centre = hn::Set(wide, weight[0]);
    const float* middle = rows[radius] + i;
    auto a = hn::Mul(centre, hn::LoadU(wide, middle));
    auto b = hn::Mul(centre, hn::LoadU(wide, middle + lanes));
    auto c = hn::Mul(centre, hn::LoadU(wide, middle + 2 * lanes));
    auto e = hn::Mul(centre, hn::LoadU(wide, middle + 3 * lanes));
    for (std::size_t o = 1; o <= radius; ++o) {
      const auto w = hn::Set(wide, weight[o]);
      const float *low = rows[radius - o] + i, *high = rows[radius + o] + i;
      const auto both = [&](std::size_t at) { return hn::Add(hn::LoadU(wide, low + at), hn::LoadU(wide, high + at)); };
      a = hn::MulAdd(w, both(0), a);
      b = hn::MulAdd(w, both(lanes), b);
      c = hn::MulAdd(w, both(2 * lanes), c);
      e = hn::MulAdd(w, both(3 * lanes), e);
    }
    hn::StoreU(a, wide, out.data() + i);
    hn::StoreU(b, wide, out.data() + i + lanes);
    hn::StoreU(c, wide, out.data() + i + 2 * lanes);
    hn::StoreU(e, wide, out.data() + i + 3 * lanes);
  }
  alongRow(four, out.size(), [&](auto d, std::size_t i) {
    auto sum = hn::Mul(hn::Set(d, weight[0]), hn::LoadU(d, rows[radius] + i));
    for (std::size_t o = 1; o <= radius; ++o)
      sum = hn::MulAdd(hn::Set(d, weight[o]),
                       hn::Add(hn::LoadU(d, rows[radius - o] + i), hn::LoadU(d, rows[radius + o] + i)), sum);
    hn::StoreU(sum, d, out.data() + i);
  });
}

void leastOfRowsTarget(std::span<const float* const> rows, std::span<const float> add, std::span<float> out) {
  const hn::ScalableTag<float> wide;
  const std::size_t lanes = hn::Lanes(wide), four = out.size() / (4 * lanes) * (4 * lanes);
  for (std::size_t i = 0; i < four; i += 4 * lanes) {
    const auto first = [&](std::size_t at) {
      return hn::Add(hn::LoadU(wide, rows[0] + i + at), hn::Set(wide, add[0]));
    };
    auto a = first(0), b = first(lanes), c = first(2 * lanes), e = first(3 * lanes);
    for (std::size_t r = 1; r < rows.size(); ++r) {
      const auto more = hn::Set(wide, add[r]);
      const float* row = rows[r] + i;
      a = hn::Min(a, hn::Add(hn::LoadU(wide, row), more));
      b = hn::Min(b, hn::Add(hn::LoadU(wide, row + lanes), more));
      c = hn::Min(c, hn::Add(hn::LoadU(wide, row + 2 * lanes), more));
      e = hn::Min(e, hn::Add(hn::LoadU(wide, row + 3 * lanes), more));
    }
    hn::StoreU(a, wide, out.data() + i);
    hn::StoreU(b, wide, out.data() + i + lanes);
    hn::StoreU(c, wide, out.data() + i + 2 * lanes);
    hn::StoreU(e, wide, out.data() + i + 3 * lanes);
  }
  alongRow(four, out.size(), [&](auto d, std::size_t i) {
    auto least = hn::Add(hn::LoadU(d, rows[0] + i), hn::Set(d, add[0]));
    for (std::size_t r = 1; r < rows.size(); ++r)
      least = hn::Min(least, hn::Add(hn::LoadU(d, rows[r] + i), hn::Set(d, add[r])));
    hn::StoreU(least, d, out.data() + i);
  });
}

void leastPositiveTarget(std::span<const float> values, std::span<float> least) {
  alongRow(0, least.size(), [&](auto d, std::size_t i) {
    const auto value = hn::LoadU(d, values.data() + i), before = hn::LoadU(d, least.data() + i);
    hn::StoreU(hn::IfThenElse(hn::Gt(value, hn::Zero(d)), hn::Min(value, before), before), d, least.data() + i);
  });
}

void signedDistanceTarget(std::span<const float> outside2, std::span<const float> inside2, float half,
                          std::span<float> out) {
  alongRow(0, out.size(), [&](auto d, std::size_t i) {
    const auto outside = hn::LoadU(d, outside2.data() + i), inside = hn::LoadU(d, inside2.data() + i);
    const auto h = hn::Set(d, half);
    const auto own = hn::Eq(outside, hn::Zero(d));
    hn::StoreU(hn::IfThenElse(own, hn::Sub(h, hn::Sqrt(inside)), hn::Sub(hn::Sqrt(outside), h)), d, out.data() + i);
  });
}

}  // namespace insonate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate {
HWY_EXPORT(weighRowsTarget);
HWY_EXPORT(leastOfRowsTarget);
HWY_EXPORT(leastPositiveTarget);
HWY_EXPORT(signedDistanceTarget);

void weighRows(std::span<const float* const> rows, std::span<const float> weight, std::span<float> out) {
  HWY_DYNAMIC_DISPATCH(weighRowsTarget)(rows, weight, out);
}
void leastOfRows(std::span<const float* const> rows, std::span<const float> add, std::span<float> out) {
  HWY_DYNAMIC_DISPATCH(leastOfRowsTarget)(rows, add, out);
}
void leastPositive(std::span<const float> values, std::span<float> least) {
  HWY_DYNAMIC_DISPATCH(leastPositiveTarget)(values, least);
}
void signedDistance(std::span<const float> outside2, std::span<const float> inside2, float half, std::span<float> out) {
  HWY_DYNAMIC_DISPATCH(signedDistanceTarget)(outside2, inside2, half, out);
}
}  // namespace insonate
#endif
