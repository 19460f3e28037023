#include "live/Cine.h"

namespace insonate::live {

std::size_t bytesOf(const LiveFrame& frame) {
  return sizeof(LiveFrame) + frame.image.gray.capacity() + frame.color.rgba.capacity() +
         frame.envelope.amplitude.capacity() * sizeof(float) +
         frame.press.displacement.restFromDisplayed.capacity() * sizeof(PlaneDisplacement::Shift) +
         frame.stages.capacity() * sizeof(ImagingFrame::Stage) + frame.press.mesh.nodes.capacity() * sizeof(MeshNode) +
         frame.press.mesh.pressure_kPa.capacity() * sizeof(float);
}

Cine::Cine(std::size_t maxBytes) : maxBytes_(maxBytes), ring_(kMaxFrames) {}

void Cine::dropOldest() {
  bytes_ -= bytesOf(*ring_[first_]);
  ring_[first_].reset();
  first_ = (first_ + 1) % kMaxFrames;
  --count_;
}

void Cine::push(Frame frame) {
  const std::size_t added = bytesOf(*frame);
  while (count_ > 0 && (bytes_ + added > maxBytes_ || count_ == kMaxFrames)) dropOldest();
  bytes_ += added;
  ring_[(first_ + count_++) % kMaxFrames] = std::move(frame);
}

std::vector<Cine::Frame> Cine::last(double seconds) const {
  std::vector<Frame> frames;
  if (count_ == 0) return frames;
  const double since_s = latest()->time_s - seconds;
  std::size_t i = count_;
  while (i > 0 && at(i - 1)->time_s >= since_s) --i;
  frames.reserve(count_ - i);
  for (; i < count_; ++i) frames.push_back(at(i));
  return frames;
}

}  // namespace insonate::live
