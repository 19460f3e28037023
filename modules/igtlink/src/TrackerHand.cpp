#include "LinkTime.h"

#include <insonate/igtlink/TrackerHand.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace insonate {
namespace {

constexpr double kNominalRate_Hz = 60;
constexpr Vec3 kTrackedSpace_mm{1000, 1000, 1000};
constexpr std::int64_t kKept_ns = std::int64_t{TrackerHand::kKept_s} * 1'000'000'000, kStill_ns = 1'000'000'000;
/// A tool without a pose for this time is lost.
constexpr std::int64_t kSilence_ns = 250'000'000;
/// Velocities are computed over at least this time, since over a shorter one they consist of noise.
constexpr std::int64_t kVelocity_ns = 12'000'000;
/// The desk frame has z down into the desk; the outline's arrow points to the user's right.
const Transform kDeviceFromDesk{{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}}, {}};

struct TrackedPose {
  std::int64_t time_ns = 0;
  Transform trackerFromMarker;
};

/// Rotation from `before` to `after` as a vector along its axis, with the angle as its length.
Vec3 turnBetween(const Mat3& before, const Mat3& after) {
  const Mat3 turn = after * transposed(before);
  const auto& c = turn.column;
  const Vec3 axis{c[1].z - c[2].y, c[2].x - c[0].z, c[0].y - c[1].x};
  const double sine = norm(axis) / 2, cosine = (c[0].x + c[1].y + c[2].z - 1) / 2;
  return sine < 1e-9 ? Vec3{} : axis / (2 * sine) * std::atan2(sine, cosine);
}

/// Stylus at the tip; -z from the marker to the tip, x as near as possible to the marker's x.
Transform stylusAt(Vec3 tip_marker) {
  if (norm(tip_marker) < 1) return {{}, tip_marker};
  const Vec3 z = -normalized(tip_marker), near = std::abs(z.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 x = normalized(near - dot(near, z) * z);
  return {{{x, cross(z, x), z}}, tip_marker};
}

std::string deviceName(const std::string& tool) {
  return tool.empty() ? "Tracker" : "Tracker: " + tool;
}

}  // namespace

class TrackerHand::Impl {
 public:
  Impl(const std::string& host, int port, std::string tool, const TrackerCalibration& calibration)
      : device_(std::make_shared<PoseDevice>("tracker:" + host + ":" + std::to_string(port) + "/" + tool,
                                             deviceName(tool), kNominalRate_Hz, kTrackedSpace_mm)),
        tool_(std::move(tool)),
        calibration_(calibration),
        client_(host, port,
                [this](const std::vector<LinkToolPose>& poses, const std::string& error) { take(poses, error); }) {}

  std::shared_ptr<PoseDevice> device() const { return device_; }
  LinkClientStatus status() const { return client_.status(); }
  TrackerCalibration calibration() const {
    const std::scoped_lock lock(mutex_);
    return calibration_;
  }
  Result<PivotCalibration> calibrateTip() {
    auto pivot = calibratePivot(posesOfLast(kKept_ns));
    if (!pivot) return pivot;
    const std::scoped_lock lock(mutex_);
    calibration_.markerFromStylus = stylusAt(pivot->tip_body);
    return pivot;
  }
  Result<DeskRegistration> setDesk() {
    const Transform markerFromProbe{{}, calibration().markerFromStylus.offset};
    auto desk = registerDesk(posesOfLast(kStill_ns), markerFromProbe);
    if (!desk) return desk;
    const std::scoped_lock lock(mutex_);
    calibration_.deviceFromTracker = kDeviceFromDesk * inverted(desk->cameraFromDesk);
    return desk;
  }

 private:
  void take(const std::vector<LinkToolPose>& poses, const std::string& error) {
    for (const LinkToolPose& pose : poses) {
      if (tool_.empty()) tool_ = pose.name;
      if (pose.name == tool_)
        follow({pose.time_ns, pose.trackerFromTool});
      else
        other_ = pose.name;
    }
    const std::int64_t now_ns = monotonicTime_ns();
    if (now_ns - last_ns_ < kSilence_ns) return;
    const std::string sentence = silenceSentence(error);
    if (std::exchange(sentence_, sentence) == sentence && isLost_) return;
    isLost_ = true;
    device_->setQuality({0, 0, sentence});
    device_->setPhase(last_ns_ == 0 && error.empty() ? DevicePhase::kReady : DevicePhase::kLost, sentence);
  }

  std::string silenceSentence(const std::string& error) const {
    if (!error.empty()) return error;
    if (last_ns_ == 0 && !other_.empty())
      return "The tracker sends no tool '" + tool_ + "', but for example '" + other_ + "'.";
    if (last_ns_ == 0) return "The tracker has sent no pose yet.";
    return "The tracker does not see " + tool_ + ". Turn the marker toward the tracker.";
  }

  void follow(const TrackedPose& pose) {
    std::optional<TrackedPose> before;
    TrackerCalibration places;
    {
      const std::scoped_lock lock(mutex_);
      // A sender may repeat its last pose until the next measurement.
      if (!kept_.empty() && pose.time_ns <= kept_.back().time_ns) return;
      for (auto past = kept_.rbegin(); past != kept_.rend() && !before; ++past)
        if (pose.time_ns - past->time_ns >= kVelocity_ns) before = *past;
      kept_.push_back(pose);
      while (pose.time_ns - kept_.front().time_ns > kKept_ns) kept_.pop_front();
      places = calibration_;
    }
    const auto deviceFromStylus = [&](const TrackedPose& at) {
      return places.deviceFromTracker * at.trackerFromMarker * places.markerFromStylus;
    };
    DeviceState state;
    state.deviceFromStylus = deviceFromStylus(pose);
    state.time_ns = pose.time_ns;
    if (before && pose.time_ns - before->time_ns < kSilence_ns) {
      const Transform former = deviceFromStylus(*before);
      const double step_s = static_cast<double>(pose.time_ns - before->time_ns) * 1e-9;
      state.velocity_mmps = (state.deviceFromStylus.offset - former.offset) / step_s;
      state.angularVelocity_radps = turnBetween(former.linear, state.deviceFromStylus.linear) / step_s;
    }
    last_ns_ = monotonicTime_ns();
    if (std::exchange(isLost_, false)) device_->setQuality({});
    device_->post(state);
  }

  std::vector<Transform> posesOfLast(std::int64_t time_ns) const {
    const std::scoped_lock lock(mutex_);
    std::vector<Transform> poses;
    for (const TrackedPose& pose : kept_)
      if (kept_.back().time_ns - pose.time_ns <= time_ns) poses.push_back(pose.trackerFromMarker);
    return poses;
  }

  const std::shared_ptr<PoseDevice> device_;
  // The following members are used by the client's thread.
  std::string tool_, other_;  ///< other_: name of a tool that is not this one
  std::string sentence_;
  std::int64_t last_ns_ = 0;  ///< arrival of the last pose, CLOCK_MONOTONIC; 0: none yet
  bool isLost_ = false;
  mutable std::mutex mutex_;  ///< guards kept_ and calibration_
  std::deque<TrackedPose> kept_;
  TrackerCalibration calibration_;
  LinkClient client_;
};

TrackerHand::TrackerHand(const std::string& host, int port, const std::string& tool,
                         const TrackerCalibration& calibration)
    : impl_(std::make_unique<Impl>(host, port, tool, calibration)) {}

TrackerHand::~TrackerHand() {
  const std::shared_ptr<PoseDevice> device = impl_->device();
  impl_.reset();
  device->setPhase(DevicePhase::kAbsent);
}

std::shared_ptr<PoseDevice> TrackerHand::device() const {
  return impl_->device();
}

LinkClientStatus TrackerHand::status() const {
  return impl_->status();
}

TrackerCalibration TrackerHand::calibration() const {
  return impl_->calibration();
}

Result<PivotCalibration> TrackerHand::calibrateTip() {
  return impl_->calibrateTip();
}

Result<DeskRegistration> TrackerHand::setDesk() {
  return impl_->setDesk();
}

}  // namespace insonate
