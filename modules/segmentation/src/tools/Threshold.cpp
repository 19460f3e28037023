#include <insonate/segmentation/Threshold.h>

#include <tbb/parallel_for.h>

#include <algorithm>

namespace insonate {
namespace {

/// Calls `row(hu, chosen, count)` for each row of the box.
template <class Row>
void rows(const CtVolume& ct, Selection& chosen, const Row& row) {
  const VoxelBox& box = chosen.box;
  if (box.empty()) return;
  tbb::parallel_for(0, box.length(2), [&](int k) {
    for (int j = 0; j < box.length(1); ++j)
      row(&ct.at(box.first[0], box.first[1] + j, box.first[2] + k), &chosen.mask.at(0, j, k), box.length(0));
  });
}

}  // namespace

void threshold(const CtVolume& ct, HuRange range, Selection& chosen) {
  // In the CT's own 16 bits, eight voxels are compared at once.
  const auto low = static_cast<std::int16_t>(std::clamp(range.low, -32768, 32767));
  const auto high = static_cast<std::int16_t>(std::clamp(range.high, -32768, 32767));
  const bool none = range.low > range.high || range.low > 32767 || range.high < -32768;
  rows(ct, chosen, [=](const std::int16_t* hu, std::uint8_t* out, int count) {
    if (none) {
      std::fill_n(out, count, std::uint8_t{0});
      return;
    }
    for (int i = 0; i < count; ++i) out[i] = static_cast<std::uint8_t>((hu[i] >= low) & (hu[i] <= high));
  });
}

void limitTo(const CtVolume& ct, HuRange range, Selection& chosen) {
  rows(ct, chosen, [=](const std::int16_t* hu, std::uint8_t* out, int count) {
    for (int i = 0; i < count; ++i) out[i] &= static_cast<std::uint8_t>(range.contains(hu[i]));
  });
}

}  // namespace insonate
