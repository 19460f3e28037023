#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace insonate {

/// Pixels of one frame of a video, sRGB, rows from the top.
struct VideoFrame {
  int width = 0, height = 0;         ///< all frames of a video have the same even width and height, 16..4096
  int channels = 3;                  ///< 1: gray; 3: red, green, blue
  std::vector<std::uint8_t> pixels;  ///< values of the pixels, index [row][column][channel]
};

struct VideoFormat {
  int framesPerSecond = 15;  ///< 1..60; times of frames are rounded to milliseconds
  /// Level of constant quality (quantizer), 0..63; lower is better and larger. With 24, simulated images with speckle
  /// differ from the original by an RMS error of about 3 gray values.
  int quality = 24;
};

/// Maximum interval between key frames, from which a player can begin to decode.
inline constexpr double kMaxBetweenKeyFrames_s = 2;

/// Writes `count` frames as VP9 in WebM, with duration and cues (places to which a player jumps). `draw` makes frame
/// `index`; it is called for 0 to count - 1, on the calling thread. The file is written atomically: after a failure,
/// `target` is unchanged. Equal frames give equal files. Fails if `draw` fails, when cancelled, on frames of another
/// size, or if the file cannot be written.
Result<void> writeVideo(const std::filesystem::path& target, const VideoFormat& format, std::int64_t count,
                        const std::function<Result<void>(std::int64_t index, VideoFrame& frame)>& draw,
                        const Progress& progress = {});

}  // namespace insonate
