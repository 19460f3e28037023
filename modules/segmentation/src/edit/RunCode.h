#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace insonate::segmentation {

/// Consecutive voxels that an edit changed from one label to another.
struct ChangedRun {
  std::size_t begin, length;  ///< first voxel and number of voxels; voxels of a slice are numbered j * ni + i
  std::uint8_t before, after;
};

/// Packs the changed runs of one slice as bytes, in increasing order, usually four bytes per run: the gap since the
/// previous run and the run's length, both with seven bits per byte, then the labels before and after.
class RunPacker {
 public:
  void add(std::size_t voxel, std::uint8_t before, std::uint8_t after);
  /// Returns the packed bytes; call after the last voxel.
  std::vector<std::uint8_t> take();

 private:
  void flush();
  void number(std::size_t value);

  std::vector<std::uint8_t> bytes_;
  ChangedRun run_{0, 0, 0, 0};
  std::size_t packed_ = 0;  ///< voxel after the last run that is packed in bytes_
};

/// Unpacks runs: calls `visit(const ChangedRun&)` for each run in order.
template <class Visit>
void unpackRuns(const std::vector<std::uint8_t>& bytes, const Visit& visit) {
  std::size_t at = 0, end = 0;
  const auto number = [&] {
    std::size_t value = 0;
    for (int shift = 0;; shift += 7) {
      const std::uint8_t byte = bytes[at++];
      value |= std::size_t(byte & 0x7f) << shift;
      if (!(byte & 0x80)) return value;
    }
  };
  while (at < bytes.size()) {
    ChangedRun run{};
    run.begin = end + number();
    run.length = number();
    run.before = bytes[at++], run.after = bytes[at++];
    end = run.begin + run.length;
    visit(run);
  }
}

}  // namespace insonate::segmentation
