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

  /// Adds a frame and drops the oldest frames until all fit; the latest frame stays even if it does not fit.
  void push(Frame frame);
  Frame latest() const { return count_ ? at(count_ - 1) : nullptr; }
  /// Frames that are at most `seconds` older than the latest frame, oldest first.
  std::vector<Frame> last(double seconds) const;

 private:
  static constexpr std::size_t kMaxFrames = 4096;

  const Frame& at(std::size_t i) const { return ring_[(first_ + i) % kMaxFrames]; }
  void dropOldest();

  std::size_t mostBytes_, bytes_ = 0;
  std::size_t first_ = 0, count_ = 0;
  std::vector<Frame> ring_;
};

/// Memory that a frame occupies, including memory that it keeps for its next use.
std::size_t bytesOf(const LiveFrame& frame);

}  // namespace insonate::live
