// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/RowFilters.cpp"
#include <hwy/foreach_target.h>
// After foreach_target:
#include "scene/RowFilters.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace insonate::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Runs `part(tag, i)` over a row: whole vectors first, then one by one.
template <class Part>
HWY_INLINE void alongRow(std::size_t size, const Part& part) {
  const hn::ScalableTag<float> wide;
  const hn::CappedTag<float, 1> single;
  std::size_t i = 0;
  for (; i + hn::Lanes(wide) <= size; i += hn::Lanes(wide)) part(wide, i);
  for (; i < size; ++i) part(single, i);
}

void weighRowsTarget(std::span<const float* const> rows, std::span<const float> weight, std::span<float> out) {
  const std::size_t radius = weight.size() - 1;
  alongRow(out.size(), [&](auto d, std::size_t i) {
    auto sum = hn::Mul(hn::Set(d, weight[0]), hn::LoadU(d, rows[radius] + i));
    for (std::size_t o = 1; o <= radius; ++o)
      sum = hn::MulAdd(hn::Set(d, weight[o]),
                       hn::Add(hn::LoadU(d, rows[radius - o] + i), hn::LoadU(d, rows[radius + o] + i)), sum);
    hn::StoreU(sum, d, out.data() + i);
  });
}

void leastOfRowsTarget(std::span<const float* const> rows, std::span<const float> add, std::span<float> out) {
  alongRow(out.size(), [&](auto d, std::size_t i) {
    auto least = hn::Add(hn::LoadU(d, rows[0] + i), hn::Set(d, add[0]));
    for (std::size_t r = 1; r < rows.size(); ++r)
      least = hn::Min(least, hn::Add(hn::LoadU(d, rows[r] + i), hn::Set(d, add[r])));
    hn::StoreU(least, d, out.data() + i);
  });
}

}  // namespace insonate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate {
HWY_EXPORT(weighRowsTarget);
HWY_EXPORT(leastOfRowsTarget);

void weighRows(std::span<const float* const> rows, std::span<const float> weight, std::span<float> out) {
  HWY_DYNAMIC_DISPATCH(weighRowsTarget)(rows, weight, out);
}
void leastOfRows(std::span<const float* const> rows, std::span<const float> add, std::span<float> out) {
  HWY_DYNAMIC_DISPATCH(leastOfRowsTarget)(rows, add, out);
}
}  // namespace insonate
#endif
