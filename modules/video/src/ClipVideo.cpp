#include <insonate/video/ClipVideo.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace insonate {
namespace {

/// Sides of the frames of a video are even, and not shorter.
constexpr int kShortest_px = 16;

int sideOf(int side) {
  return std::max(kShortest_px, side + side % 2);
}

/// Copies `frame` into the upper left corner of a black frame of the video's size.
Result<void> place(const VideoFrame& frame, const ClipVideo& clip, VideoFrame& whole) {
  if (frame.width > clip.width || frame.height > clip.height)
    return fail("A frame of " + std::to_string(frame.width) + " x " + std::to_string(frame.height) +
                " pixels is larger than its clip.");
  whole.width = sideOf(clip.width), whole.height = sideOf(clip.height), whole.channels = frame.channels;
  const std::size_t row = std::size_t(frame.width) * frame.channels,
                    wholeRow = std::size_t(whole.width) * whole.channels;
  whole.pixels.assign(wholeRow * std::size_t(whole.height), 0);
  for (int y = 0; y < frame.height; ++y)
    std::copy_n(frame.pixels.begin() + std::ptrdiff_t(row) * y, row,
                whole.pixels.begin() + std::ptrdiff_t(wholeRow) * y);
  return {};
}

}  // namespace

Result<void> writeClipVideo(const ClipVideo& clip, const std::filesystem::path& target,
                            const std::function<Result<void>(std::size_t, VideoFrame&)>& draw,
                            const Progress& progress) {
  if (clip.time_s.empty()) return fail("The clip has no images, so that there is nothing to write.");
  const double begin_s = clip.time_s.front(), length_s = clip.time_s.back() - begin_s;
  VideoFrame frame, whole;
  std::optional<std::size_t> shown;
  const auto drawAt = [&](std::int64_t tick, VideoFrame& into) -> Result<void> {
    constexpr double kRounding_s = 1e-6;
    const double time_s = begin_s + double(tick) / kClipVideoRate + kRounding_s;
    const auto next = std::ranges::upper_bound(clip.time_s, time_s);
    const auto index = std::size_t(std::max<std::ptrdiff_t>(1, next - clip.time_s.begin()) - 1);
    if (shown != index) {
      if (auto drawn = draw(index, frame); !drawn) return drawn;
      if (auto placed = place(frame, clip, whole); !placed) return placed;
      shown = index;
    }
    into = whole;
    return {};
  };
  // The last image has a frame of its own, also if its time is between two frames.
  const auto count = std::int64_t(std::ceil(length_s * kClipVideoRate - 1e-4)) + 1;
  return writeVideo(target, {.framesPerSecond = kClipVideoRate}, count, drawAt, progress);
}

}  // namespace insonate
