#include <insonate/camera/CameraSource.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::nanoseconds kFrame{33'333'333};

class PlayedFrames : public CameraSource {
 public:
  PlayedFrames(fs::path path, std::unique_ptr<CameraSource> recording)
      : path_(std::move(path)), recording_(std::move(recording)), due_(Clock::now()) {}
  std::string name() const override { return recording_->name(); }
  int width() const override { return recording_->width(); }
  int height() const override { return recording_->height(); }

  Result<CameraStatus> next(CameraFrame& frame, std::chrono::milliseconds wait) override {
    std::this_thread::sleep_until(std::min(due_, Clock::now() + wait));
    if (Clock::now() < due_) return CameraStatus::kWaiting;
    auto status = recording_->next(frame, wait);
    if (status && *status == CameraStatus::kEnded) {
      auto again = openRecordedFrames(path_);
      if (!again) return tl::unexpected(again.error());
      recording_ = std::move(*again);
      status = recording_->next(frame, wait);
    }
    if (!status || *status != CameraStatus::kFrame) return status;
    frame.time_ns = std::chrono::nanoseconds(due_.time_since_epoch()).count();
    due_ = std::max(due_ + kFrame, Clock::now());
    return status;
  }

 private:
  fs::path path_;
  std::unique_ptr<CameraSource> recording_;
  Clock::time_point due_;  ///< time of the next frame
};

}  // namespace

Result<std::unique_ptr<CameraSource>> openPlayedFrames(const fs::path& path) {
  auto recording = openRecordedFrames(path);
  if (!recording) return tl::unexpected(recording.error());
  return std::make_unique<PlayedFrames>(path, std::move(*recording));
}

}  // namespace insonate
