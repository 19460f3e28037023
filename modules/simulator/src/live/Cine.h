#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace insonate::live {

/// The last frames, as many as fit into a given memory. Not for concurrent use.
class Cine {
 public:
  using Frame = std::shared_ptr<const LiveFrame>;

  explicit Cine(std::size_t mostBytes);

  /// Drops the oldest until the frame fits; the latest stays even where it does not.
  void push(Frame frame);
  Frame latest() const { return count_ ? at(count_ - 1) : nullptr; }
  /// Frames not older than `seconds` before the latest, oldest first.
  std::vector<Frame> last(double seconds) const;

 private:
  static constexpr std::size_t kMostFrames = 4096;

  const Frame& at(std::size_t i) const { return ring_[(first_ + i) % kMostFrames]; }
  void dropOldest();

  std::size_t mostBytes_, bytes_ = 0;
  std::size_t first_ = 0, count_ = 0;
  std::vector<Frame> ring_;
};

/// Memory that a frame takes, or keeps for its next use.
std::size_t bytesOf(const LiveFrame& frame);

}  // namespace insonate::live
