#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/video/VideoWriter.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace insonate {

/// Frame rate of the video of a clip, 1/s.
inline constexpr int kClipVideoRate = 30;

/// Size and times of a clip's frames.
struct ClipVideo {
  int width = 0, height = 0;     ///< size of the largest frame in pixels, 1..4096
  std::vector<double> time_s{};  ///< time of each frame, ascending; the intervals may vary
};

/// Writes a clip as a video (VP9 in WebM, see writeVideo()) with kClipVideoRate frames per second. A frame is shown
/// until the time of the next one. Sizes may be odd, and frames may be smaller than the clip; the rest is black. `draw`
/// makes frame `index` of the clip, in ascending order, and not more than once; frames that are shorter than an
/// interval of the video are left out. Fails as writeVideo() does, on a clip of no frames, and on a frame that is
/// larger than the clip.
Result<void> writeClipVideo(const ClipVideo& clip, const std::filesystem::path& target,
                            const std::function<Result<void>(std::size_t index, VideoFrame& frame)>& draw,
                            const Progress& progress = {});

}  // namespace insonate
