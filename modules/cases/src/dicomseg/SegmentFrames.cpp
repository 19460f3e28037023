#include "SegmentFrames.h"

#include <array>
#include <span>
#include <string>

namespace insonate {
namespace {

using Slice = std::span<const std::uint8_t>;

Slice sliceOf(const LabelMap& map, int k) {
  const std::size_t size = static_cast<std::size_t>(map.geometry.size[0]) * map.geometry.size[1];
  return {map.voxels.data() + static_cast<std::size_t>(k) * size, size};
}

/// Appends a frame behind the first `used` bits.
void addBits(Slice slice, std::uint8_t label, std::size_t used, std::vector<std::uint8_t>& bits) {
  bits.resize((used + slice.size() + 7) / 8);
  for (std::size_t n = 0; n < slice.size(); ++n)
    if (slice[n] == label) bits[(used + n) / 8] |= static_cast<std::uint8_t>(1U << ((used + n) % 8));
}

}  // namespace

Result<SegmentFrames> framesOfLabels(const LabelMap& map, const Progress& progress) {
  const int slices = map.geometry.size[2];
  std::vector<std::array<bool, 256>> occurs(static_cast<std::size_t>(slices));
  std::array<bool, 256> anywhere{};
  for (int k = 0; k < slices; ++k)
    for (const std::uint8_t label : sliceOf(map, k))
      anywhere[label] = occurs[static_cast<std::size_t>(k)][label] = true;

  SegmentFrames result;
  std::size_t used = 0;
  for (int label = 1; label < 256; ++label) {
    if (!anywhere[label]) continue;
    if (!report(progress, "Writing the segmentation", label / 256.0)) return fail(std::string(kCancelled));
    const auto number = static_cast<std::uint8_t>(label);
    for (int k = 0; k < slices; ++k) {
      if (!occurs[static_cast<std::size_t>(k)][label]) continue;
      result.frames.push_back({static_cast<int>(result.labels.size()), k});
      addBits(sliceOf(map, k), number, used, result.bits);
      used += sliceOf(map, k).size();
    }
    result.labels.push_back(number);
  }
  return result;
}

}  // namespace insonate
