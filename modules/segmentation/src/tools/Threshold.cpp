#include <insonate/segmentation/Threshold.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace insonate {
namespace {

/// Calls `row(hu, out, count, offset)` for each row of the box; `offset` is that of its first voxel in the whole grid.
template <class Row>
void rows(const CtVolume& ct, const VoxelBox& box, Volume<std::uint8_t>& out, const Row& row) {
  if (box.empty()) return;
  tbb::parallel_for(0, box.length(2), [&](int k) {
    for (int j = 0; j < box.length(1); ++j) {
      const std::size_t offset = ct.geometry.offset(box.first[0], box.first[1] + j, box.first[2] + k);
      row(&ct.voxels[offset], &out.at(0, j, k), box.length(0), offset);
    }
  });
}

/// A range in the CT's 16 bits, so that eight voxels are compared at once.
class Range16 {
 public:
  explicit Range16(HuRange range)
      : none_(range.low > range.high || range.low > 32767 || range.high < -32768),
        low_(static_cast<std::int16_t>(std::clamp(range.low, -32768, 32767))),
        high_(static_cast<std::int16_t>(std::clamp(range.high, -32768, 32767))) {}

  /// Sets `in` for each voxel within the range, `outside` for all others.
  void mark(const std::int16_t* hu, std::uint8_t* out, int count, std::uint8_t in, std::uint8_t outside) const {
    if (none_) {
      std::fill_n(out, count, outside);
      return;
    }
    const auto turned = static_cast<std::uint8_t>(in ^ outside);
    for (int i = 0; i < count; ++i) {
      const auto all = static_cast<std::uint8_t>(-((hu[i] >= low_) & (hu[i] <= high_)));
      out[i] = static_cast<std::uint8_t>(outside ^ (turned & all));
    }
  }

 private:
  bool none_;
  std::int16_t low_, high_;
};

/// Calls `visit(i)` for each voxel of the row that is not kKeep.
template <class Visit>
void eachProposed(const std::uint8_t* row, int count, const Visit& visit) {
  constexpr int kWord = sizeof(std::uint64_t);
  int i = 0;
  for (; i + kWord <= count; i += kWord) {
    std::uint64_t word = 0;
    std::memcpy(&word, row + i, kWord);
    if (word == ~std::uint64_t{0}) continue;
    for (int n = i; n < i + kWord; ++n)
      if (row[n] != Proposal::kKeep) visit(n);
  }
  for (; i < count; ++i)
    if (row[i] != Proposal::kKeep) visit(i);
}

}  // namespace

void threshold(const CtVolume& ct, HuRange range, Selection& chosen) {
  const Range16 wanted(range);
  rows(ct, chosen.box, chosen.mask,
       [&](const std::int16_t* hu, std::uint8_t* out, int count, std::size_t) { wanted.mark(hu, out, count, 1, 0); });
}

void proposeThreshold(const CtVolume& ct, HuRange range, std::uint8_t label, const EditRules& rules,
                      const LabelMap& labels, const VoxelBox& box, Proposal& into) {
  static_assert(Proposal::kKeep == 0xFF, "as eachProposed() has it");
  const VolumeGeometry grid = box.empty() ? VolumeGeometry{} : gridOf(ct.geometry, box);
  if (into.labels.voxels.size() != (box.empty() ? 0 : grid.voxelCount()))
    into.labels = box.empty() ? Volume<std::uint8_t>() : Volume<std::uint8_t>(grid);
  into.box = box, into.labels.geometry = grid;
  EditRules ofLabels = rules;
  ofLabels.editable.reset();
  std::array<bool, 256> gives{};
  for (int before = 0; before < 256; ++before)
    gives[std::size_t(before)] = ofLabels.allow(static_cast<std::uint8_t>(before), label, 0);
  const HuRange editable = rules.editable.value_or(HuRange{});
  const Range16 wanted(range);
  rows(ct, box, into.labels, [&](const std::int16_t* hu, std::uint8_t* out, int count, std::size_t offset) {
    wanted.mark(hu, out, count, label, Proposal::kKeep);
    const std::uint8_t* before = &labels.voxels[offset];
    eachProposed(out, count, [&](int i) {
      if (before[i] != label && !(gives[before[i]] && editable.contains(hu[i]))) out[i] = Proposal::kKeep;
    });
  });
}

void removeOutside(const CtVolume& ct, HuRange range, Selection& chosen) {
  rows(ct, chosen.box, chosen.mask, [=](const std::int16_t* hu, std::uint8_t* out, int count, std::size_t) {
    for (int i = 0; i < count; ++i) out[i] &= static_cast<std::uint8_t>(range.contains(hu[i]));
  });
}

}  // namespace insonate
