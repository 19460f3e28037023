#include "RunCode.h"

#include <utility>

namespace insonate::segmentation {

void RunPacker::add(std::size_t voxel, std::uint8_t before, std::uint8_t after) {
  if (run_.length > 0 && voxel == run_.begin + run_.length && before == run_.before && after == run_.after) {
    ++run_.length;
    return;
  }
  flush();
  run_ = {voxel, 1, before, after};
}

std::vector<std::uint8_t> RunPacker::take() {
  flush();
  bytes_.shrink_to_fit();
  return std::exchange(bytes_, {});
}

void RunPacker::flush() {
  if (run_.length == 0) return;
  number(run_.begin - packed_);
  number(run_.length);
  bytes_.push_back(run_.before);
  bytes_.push_back(run_.after);
  packed_ = run_.begin + run_.length;
  run_.length = 0;
}

void RunPacker::number(std::size_t value) {
  for (; value >= 0x80; value >>= 7) bytes_.push_back(static_cast<std::uint8_t>(value | 0x80));
  bytes_.push_back(static_cast<std::uint8_t>(value));
}

}  // namespace insonate::segmentation
