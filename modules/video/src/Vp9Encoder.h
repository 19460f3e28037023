#pragma once

#include <insonate/core/Result.h>
#include <insonate/video/VideoWriter.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace insonate::video {

/// Encodes frames as VP9 (libvpx) with constant quality.
class Vp9Encoder {
 public:
  /// Takes an encoded frame; frames arrive in the order of their times, some frames later than they were encoded.
  using Take = std::function<void(std::span<const std::uint8_t> packet, std::int64_t time_ms, bool isKey)>;

  /// Fails if libvpx refuses the size or the format.
  static Result<Vp9Encoder> make(int width, int height, const VideoFormat& format, Take take);
  Vp9Encoder(Vp9Encoder&&) noexcept;
  ~Vp9Encoder();

  /// Encodes a frame of the size of make().
  Result<void> add(const VideoFrame& frame, std::int64_t time_ms, std::int64_t duration_ms);
  /// Encodes the frames that are still waiting.
  Result<void> finish();

 private:
  struct State;
  explicit Vp9Encoder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate::video
