#pragma once

#include <insonate/camera/CameraFrame.h>
#include <insonate/core/Result.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace insonate {

/// State of a source after a call of next().
enum class CameraStatus : std::uint8_t {
  kFrame,    ///< a frame was read
  kWaiting,  ///< no frame arrived in time; a later call may return one
  kEnded,    ///< a recording has no more frames
};

/// A source of gray frames: a camera, or a recording. All frames have the same size. Use an object on one thread at a
/// time.
class CameraSource {
 public:
  virtual ~CameraSource() = default;

  /// Name for the user: that of the camera, or the path of the recording.
  virtual std::string name() const = 0;
  virtual int width() const = 0;
  virtual int height() const = 0;
  /// Waits for the next frame, at most for `wait`, and copies it into `frame`. If several frames of a camera are
  /// waiting, only the latest one is returned. Fails with a sentence if the camera was unplugged or a file is damaged.
  virtual Result<CameraStatus> next(CameraFrame& frame, std::chrono::milliseconds wait) = 0;
};

/// Opens a recording: a folder with frames as PGM or PNG files (in the order of their names), or a raw file whose name
/// states size and format, such as `hands_1280x720.y8` (a byte for each pixel) or `hands_1280x720.yuyv`. Frames are 1 /
/// 30 s apart and are returned at once.
Result<std::unique_ptr<CameraSource>> openRecordedFrames(const std::filesystem::path& path);

/// Opens a recording as if it were a camera: frames arrive 1 / 30 s apart, with the present time, and begin again when
/// the recording ends.
Result<std::unique_ptr<CameraSource>> openPlayedFrames(const std::filesystem::path& path);

/// Writes a frame as a PGM file.
Result<void> writePgm(const CameraFrame& frame, const std::filesystem::path& file);

}  // namespace insonate
