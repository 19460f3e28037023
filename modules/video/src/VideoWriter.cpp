#include "Vp9Encoder.h"
#include "webm/WebmFile.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/core/Range.h>
#include <insonate/video/VideoWriter.h>

#include <fstream>
#include <optional>
#include <string>

namespace insonate {
namespace {

constexpr int kLeast_px = 16, kMost_px = 4096;

std::int64_t timeOf_ms(std::int64_t index, const VideoFormat& format) {
  return (index * 1000 + format.framesPerSecond / 2) / format.framesPerSecond;
}

Result<void> checkFormat(const VideoFormat& format, std::int64_t count) {
  if (format.framesPerSecond < 1 || format.framesPerSecond > 60)
    return fail("A video has 1 to 60 frames per second, not " + std::to_string(format.framesPerSecond) + ".");
  if (format.quality < 0 || format.quality > 63)
    return fail("The quality of a video is 0 to 63, not " + std::to_string(format.quality) + ".");
  if (count < 1) return fail("The video would have no frames.");
  return {};
}

Result<void> checkFrame(const VideoFrame& frame, const VideoFrame& first) {
  const bool isUsable = frame.width >= kLeast_px && frame.width <= kMost_px && frame.height >= kLeast_px &&
                        frame.height <= kMost_px && frame.width % 2 == 0 && frame.height % 2 == 0 &&
                        (frame.channels == 1 || frame.channels == 3) &&
                        frame.pixels.size() == std::size_t(frame.width) * frame.height * frame.channels;
  const std::string size = std::to_string(frame.width) + " x " + std::to_string(frame.height);
  if (!isUsable)
    return fail("A frame of " + size + " pixels cannot be in a video. Width and height must be even, " +
                std::to_string(kLeast_px) + " to " + std::to_string(kMost_px) + ".");
  if (frame.width != first.width || frame.height != first.height)
    return fail("A frame has " + size + " pixels, and the first frame has another size. Use one size for all frames.");
  return {};
}

}  // namespace

Result<void> writeVideo(const std::filesystem::path& target, const VideoFormat& format, std::int64_t count,
                        const std::function<Result<void>(std::int64_t index, VideoFrame& frame)>& draw,
                        const Progress& progress) {
  if (auto ok = checkFormat(format, count); !ok) return ok;
  return writeAtomically(target, [&](const std::filesystem::path& beside) -> Result<void> {
    std::ofstream out(beside, std::ios::binary);
    std::optional<video::WebmFile> file;
    std::optional<video::Vp9Encoder> encoder;
    VideoFrame frame, first;
    for (std::int64_t i = 0; i < count; ++i) {
      if (!report(progress, "making the video", double(i) / double(count))) return fail(std::string(kCancelled));
      if (auto drawn = draw(i, frame); !drawn) return drawn;
      if (i == 0) first.width = frame.width, first.height = frame.height;
      if (auto ok = checkFrame(frame, first); !ok) return ok;
      if (!encoder) {
        file.emplace(out, frame.width, frame.height);
        auto made = video::Vp9Encoder::make(
            frame.width, frame.height, format,
            [&](auto packet, std::int64_t time_ms, bool isKey) { file->add(packet, time_ms, isKey); });
        if (!made) return tl::unexpected(made.error());
        encoder.emplace(std::move(*made));
      }
      const std::int64_t time_ms = timeOf_ms(i, format);
      if (auto ok = encoder->add(frame, time_ms, timeOf_ms(i + 1, format) - time_ms); !ok) return ok;
      if (!out) break;
    }
    if (auto ok = encoder->finish(); !ok) return ok;
    file->close(timeOf_ms(count, format));
    out.close();
    if (out) return {};
    return fail("Could not write " + target.string() +
                ": the disk is full or the folder cannot be written. Free space or choose another folder.");
  });
}

}  // namespace insonate
