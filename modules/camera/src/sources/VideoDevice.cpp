#include "sources/PixelFormats.h"
#include "sources/VideoErrors.h"

#include <insonate/camera/VideoDevice.h>

#include <fcntl.h>
#include <linux/videodev2.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

namespace insonate {
namespace {

namespace fs = std::filesystem;

/// ioctl() that is repeated when a signal interrupts it. Returns errno, 0 on success.
template <class Argument>
int request(int file, unsigned long code, Argument* argument) {
  while (ioctl(file, code, argument) != 0)
    if (errno != EINTR) return errno;
  return 0;
}

/// A file descriptor that is closed at the end.
class FileHandle {
 public:
  explicit FileHandle(int file) : file_(file) {}
  FileHandle(FileHandle&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  FileHandle& operator=(FileHandle&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  ~FileHandle() {
    if (file_ >= 0) close(file_);
  }
  int get() const { return file_; }

 private:
  int file_;
};

/// A buffer that the driver fills, mapped into memory.
class MappedBuffer {
 public:
  MappedBuffer(void* memory, std::size_t size) : memory_(memory), size_(size) {}
  MappedBuffer(MappedBuffer&& other) noexcept : memory_(std::exchange(other.memory_, MAP_FAILED)), size_(other.size_) {}
  MappedBuffer& operator=(MappedBuffer&& other) noexcept {
    std::swap(memory_, other.memory_), std::swap(size_, other.size_);
    return *this;
  }
  ~MappedBuffer() {
    if (memory_ != MAP_FAILED) munmap(memory_, size_);
  }
  std::span<const std::uint8_t> bytes(std::size_t used) const {
    return {static_cast<const std::uint8_t*>(memory_), std::min(used, size_)};
  }

 private:
  void* memory_;
  std::size_t size_;
};

std::optional<v4l2_capability> captureCapability(int file) {
  v4l2_capability capability{};
  if (request(file, VIDIOC_QUERYCAP, &capability) != 0) return std::nullopt;
  const auto flags =
      (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? capability.device_caps : capability.capabilities;
  if ((flags & V4L2_CAP_VIDEO_CAPTURE) == 0 || (flags & V4L2_CAP_STREAMING) == 0) return std::nullopt;
  return capability;
}

/// Sets the first format that the camera has; no value if it has none.
std::optional<v4l2_pix_format> chosenFormat(int file, int width, int height, int& error) {
  for (const std::uint32_t format : {V4L2_PIX_FMT_GREY, V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_MJPEG}) {
    v4l2_format wanted{};
    wanted.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    wanted.fmt.pix.width = std::uint32_t(width), wanted.fmt.pix.height = std::uint32_t(height);
    wanted.fmt.pix.pixelformat = format, wanted.fmt.pix.field = V4L2_FIELD_NONE;
    error = request(file, VIDIOC_S_FMT, &wanted);
    if (error == EBUSY) return std::nullopt;
    if (error != 0 || wanted.fmt.pix.pixelformat != format) continue;
    v4l2_streamparm rate{};
    rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    rate.parm.capture.timeperframe = {1, 30};
    request(file, VIDIOC_S_PARM, &rate);  // A camera without this setting keeps its own rate.
    // Cameras send large raw images at a few frames per second only; MJPEG then is faster.
    const double fps = double(rate.parm.capture.timeperframe.denominator) /
                       std::max(1.0, double(rate.parm.capture.timeperframe.numerator));
    constexpr double kSlow_fps = 20;
    if (format != V4L2_PIX_FMT_MJPEG && fps < kSlow_fps) continue;
    return wanted.fmt.pix;
  }
  return std::nullopt;
}

class VideoDevice : public CameraSource {
 public:
  VideoDevice(FileHandle file, std::string path, std::string name, const v4l2_pix_format& format)
      : file_(std::move(file)), path_(std::move(path)), name_(std::move(name)), format_(format) {}
  VideoDevice(const VideoDevice&) = delete;
  VideoDevice& operator=(const VideoDevice&) = delete;
  ~VideoDevice() override {
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    request(file_.get(), VIDIOC_STREAMOFF, &type);
  }

  /// Asks for buffers and begins to capture; returns errno, 0 on success.
  int start() {
    v4l2_requestbuffers buffers{};
    buffers.count = 4, buffers.type = V4L2_BUF_TYPE_VIDEO_CAPTURE, buffers.memory = V4L2_MEMORY_MMAP;
    if (const int error = request(file_.get(), VIDIOC_REQBUFS, &buffers)) return error;
    for (std::uint32_t i = 0; i < buffers.count; ++i) {
      v4l2_buffer buffer = emptyBuffer(i);
      if (const int error = request(file_.get(), VIDIOC_QUERYBUF, &buffer)) return error;
      void* memory = mmap(nullptr, buffer.length, PROT_READ, MAP_SHARED, file_.get(), off_t(buffer.m.offset));
      if (memory == MAP_FAILED) return errno;
      buffers_.emplace_back(memory, buffer.length);
      if (const int error = request(file_.get(), VIDIOC_QBUF, &buffer)) return error;
    }
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    return request(file_.get(), VIDIOC_STREAMON, &type);
  }

  std::string name() const override { return name_; }
  int width() const override { return int(format_.width); }
  int height() const override { return int(format_.height); }

  Result<CameraStatus> next(CameraFrame& frame, std::chrono::milliseconds wait) override {
    pollfd waiting{file_.get(), POLLIN, 0};
    const int ready = poll(&waiting, 1, int(wait.count()));
    if (ready < 0 && errno != EINTR) return fail(camera::videoError(path_, errno));
    if (ready <= 0) return CameraStatus::kWaiting;
    if ((waiting.revents & (POLLERR | POLLHUP)) != 0) return fail(camera::videoError(path_, ENODEV));
    std::optional<v4l2_buffer> latest;
    for (;;) {
      v4l2_buffer buffer = emptyBuffer(0);
      const int error = request(file_.get(), VIDIOC_DQBUF, &buffer);
      if (error == EAGAIN) break;
      if (error != 0) return fail(camera::videoError(path_, error));
      if (latest) request(file_.get(), VIDIOC_QBUF, &*latest);
      latest = buffer;
    }
    if (!latest) return CameraStatus::kWaiting;
    const bool isWhole = latest->index < buffers_.size() && (latest->flags & V4L2_BUF_FLAG_ERROR) == 0 &&
                         decode(buffers_[latest->index].bytes(latest->bytesused), frame);
    setTime(*latest, frame);
    if (const int error = request(file_.get(), VIDIOC_QBUF, &*latest)) return fail(camera::videoError(path_, error));
    // A damaged frame is skipped: it happens when the bus is busy.
    return isWhole ? CameraStatus::kFrame : CameraStatus::kWaiting;
  }

 private:
  static v4l2_buffer emptyBuffer(std::uint32_t index) {
    v4l2_buffer buffer{};
    buffer.index = index, buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE, buffer.memory = V4L2_MEMORY_MMAP;
    return buffer;
  }

  bool decode(std::span<const std::uint8_t> bytes, CameraFrame& frame) const {
    frame.width = width(), frame.height = height();
    if (format_.pixelformat == V4L2_PIX_FMT_MJPEG)
      return camera::grayFromJpeg(bytes, frame.width, frame.height, frame.pixels);
    if (format_.pixelformat == V4L2_PIX_FMT_YUYV)
      return camera::grayFromYuyv(bytes, frame.width, frame.height, format_.bytesperline, frame.pixels);
    return camera::grayFromGray(bytes, frame.width, frame.height, format_.bytesperline, frame.pixels);
  }

  /// The driver states when the frame began (SOE) or ended. The exposure ends before the frame is sent.
  void setTime(const v4l2_buffer& buffer, CameraFrame& frame) const {
    v4l2_control exposure{};
    exposure.id = V4L2_CID_EXPOSURE_ABSOLUTE;  // in 100 us
    const bool isKnown = request(file_.get(), VIDIOC_G_CTRL, &exposure) == 0 && exposure.value > 0;
    frame.exposure_ns = isKnown ? std::int64_t(exposure.value) * 100'000 : 0;
    const std::int64_t stamp_ns = buffer.timestamp.tv_sec * 1'000'000'000LL + buffer.timestamp.tv_usec * 1000LL;
    const bool isStart = (buffer.flags & V4L2_BUF_FLAG_TSTAMP_SRC_MASK) == V4L2_BUF_FLAG_TSTAMP_SRC_SOE;
    frame.time_ns = isStart ? stamp_ns + frame.exposure_ns / 2 : stamp_ns - frame.exposure_ns / 2;
  }

  FileHandle file_;
  std::string path_, name_;
  v4l2_pix_format format_;
  std::vector<MappedBuffer> buffers_;
};

std::string nameFrom(const v4l2_capability& capability) {
  const auto* text = reinterpret_cast<const char*>(capability.card);
  return {text, strnlen(text, sizeof capability.card)};
}

}  // namespace

std::string camera::videoError(const std::string& path, int code) {
  switch (code) {
    case ENOENT:
    case ENXIO:
      return path + ": there is no camera. Plug it in, and choose it again.";
    case ENODEV:
    case EIO:
      return path + ": the camera was unplugged. Plug it in, and choose it again.";
    case EBUSY:
      return path + ": another program uses the camera. Close that program, and choose the camera again.";
    case EACCES:
    case EPERM:
      return path +
             ": you may not open the camera. Ask your administrator to add you to the group 'video', and sign in "
             "again.";
    case ENOTTY:
    case EINVAL:
      return path + ": is no camera that Insonate can read. Choose another device.";
    case ENOSPC:
      return path + ": the USB bus has no bandwidth for the camera. Plug the camera into another port.";
    default:
      return path + ": the camera cannot be used: " + std::strerror(code) + ". Unplug it, and plug it in again.";
  }
}

std::vector<VideoDeviceInfo> listVideoDevices() {
  std::vector<VideoDeviceInfo> devices;
  std::error_code error;
  for (fs::directory_iterator entry("/dev", error), end; !error && entry != end; entry.increment(error)) {
    if (!entry->path().filename().string().starts_with("video")) continue;
    const FileHandle file(open(entry->path().c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
    if (file.get() < 0) continue;
    if (const auto capability = captureCapability(file.get()))
      devices.push_back({entry->path(), nameFrom(*capability)});
  }
  const auto before = [](const VideoDeviceInfo& a, const VideoDeviceInfo& b) { return a.path < b.path; };
  std::sort(devices.begin(), devices.end(), before);
  return devices;
}

Result<std::unique_ptr<CameraSource>> openVideoDevice(const fs::path& path, int width, int height) {
  const auto refused = [&](int code) { return fail(camera::videoError(path.string(), code)); };
  FileHandle file(open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0) return refused(errno);
  const auto capability = captureCapability(file.get());
  if (!capability) return refused(ENOTTY);
  int error = 0;
  const auto format = chosenFormat(file.get(), width, height, error);
  if (!format) return refused(error == EBUSY ? EBUSY : EINVAL);
  auto device = std::make_unique<VideoDevice>(std::move(file), path.string(), nameFrom(*capability), *format);
  if (const int failed = device->start()) return refused(failed);
  return device;
}

}  // namespace insonate
