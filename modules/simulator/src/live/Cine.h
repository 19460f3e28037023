#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace insonate::live {

/// Cine memory: the last images, as many as fit into a given memory. One object must not be used concurrently.
class Cine {
 public:
  using Frame = std::shared_ptr<const LiveFrame>;

  explicit Cine(std::size_t maxBytes);

  /// Adds an image and drops the oldest ones until all fit; the latest image is kept even if it does not fit.
  void push(Frame frame);
  Frame latest() const { return count_ ? at(count_ - 1) : nullptr; }
  /// Returns the images that are at most `seconds` older than the latest, oldest first.
  std::vector<Frame> last(double seconds) const;

 private:
  static constexpr std::size_t kMaxFrames = 4096;

  const Frame& at(std::size_t i) const { return ring_[(first_ + i) % kMaxFrames]; }
  void dropOldest();

  std::size_t maxBytes_, bytes_ = 0;
  std::size_t first_ = 0, count_ = 0;
  std::vector<Frame> ring_;
};

/// Returns the memory that a live image occupies, including reserved capacity of its buffers.
std::size_t bytesOf(const LiveFrame& frame);

}  // namespace insonate::live
