#include <insonate/camera/LensCalibration.h>
#include <insonate/camera/ToolCalibration.h>
#include <insonate/simulator/CameraHands.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

namespace insonate {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kUsualLens_deg = 68;
constexpr double kUsualRate_Hz = 30;
constexpr std::array<const char*, 2> kBodies{"probe", "needle"};
constexpr std::array<const char*, 2> kIds{"camera:probe", "camera:needle"};
constexpr std::array<const char*, 2> kNames{"Camera: probe", "Camera: needle"};

/// The stylus points along its -z axis, the tools along z.
constexpr Mat3 kToolFromStylus{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}};
/// A camera that faces the user.
constexpr Mat3 kDeviceFromCamera{{Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}};
/// Desk: x toward the arrow, z down.
constexpr Mat3 kDeviceFromDesk{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}};

std::int64_t cameraClock_ns() {
  return std::chrono::nanoseconds(Clock::now().time_since_epoch()).count();
}

std::vector<CameraView::Edge> outlineOf(const TagBody& body, const LensModel& lens, const Transform& cameraFromBody) {
  std::vector<CameraView::Edge> outline;
  std::set<std::pair<int, int>> drawn;
  for (const std::vector<int>& face : body.faces) {
    const Vec3 a = cameraFromBody * body.vertices_mm[std::size_t(face[0])];
    const Vec3 b = cameraFromBody * body.vertices_mm[std::size_t(face[1])];
    const Vec3 c = cameraFromBody * body.vertices_mm[std::size_t(face[2])];
    if (dot(cross(b - a, c - a), a) >= 0) continue;  // the face looks away from the camera
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int from = face[i], to = face[(i + 1) % face.size()];
      if (!drawn.insert(std::minmax(from, to)).second) continue;
      const auto p = project(lens, cameraFromBody * body.vertices_mm[std::size_t(from)]);
      const auto q = project(lens, cameraFromBody * body.vertices_mm[std::size_t(to)]);
      if (p && q) outline.push_back({*p, *q});
    }
  }
  return outline;
}

/// Full quality needs four tags and no advice.
double qualityOf(const TrackedHand& hand) {
  constexpr double kGoodTags = 4, kAdvised = 0.5;
  if (hand.sight != HandSight::kTracked) return 0;
  return std::min(1.0, hand.tags / kGoodTags) * (hand.advice == HandAdvice::kNone ? 1 : kAdvised);
}

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

}  // namespace

/// Objects of the camera's thread.
struct CameraHands::Work {
  std::unique_ptr<CameraSource> source;
  LensModel lens;
  std::optional<HandTracker> tracker;
  std::optional<LensCalibrator> board;
  std::optional<std::vector<Transform>> onDesk;
  int deskFrames = 0;
  std::array<bool, 2> isHeld{};  ///< true: the last pose of a hidden body was posted as being at rest
  CameraFrame frame;
  double latency_ms = 0;
  std::int64_t last_ns = 0;

  void track() {
    std::vector<TagBody> bodies;
    for (const char* name : kBodies)
      if (auto body = loadTagBody(name)) bodies.push_back(std::move(*body));
    tracker.emplace(lens, std::move(bodies));
  }
};

std::array<std::shared_ptr<PoseDevice>, 2> CameraHands::makeDevices() {
  constexpr Vec3 kInView_mm{400, 300, 400};  // at half a meter from the camera
  std::array<std::shared_ptr<PoseDevice>, 2> devices;
  for (std::size_t i = 0; i < 2; ++i)
    devices[i] = std::make_shared<PoseDevice>(kIds[i], kNames[i], kUsualRate_Hz, kInView_mm, DeviceKind::kCamera);
  return devices;
}

DeviceState stateOf(const TrackedHand& seen, const TagBody& body, const std::optional<Transform>& cameraFromDesk) {
  const Transform deviceFromCamera =
      cameraFromDesk ? Transform{kDeviceFromDesk, {}} * inverted(*cameraFromDesk) : Transform{kDeviceFromCamera, {}};
  const Transform cameraFromTool = seen.cameraFromBody * body.bodyFromTool;
  DeviceState state;
  state.deviceFromStylus = deviceFromCamera * cameraFromTool * Transform{kToolFromStylus, {}};
  if (seen.sight != HandSight::kTracked) return state;
  const Vec3 arm_mm = cameraFromTool.offset - seen.cameraFromBody.offset;
  state.velocity_mmps = deviceFromCamera.linear * (seen.velocity_mmps + cross(seen.angularVelocity_radps, arm_mm));
  state.angularVelocity_radps = deviceFromCamera.linear * seen.angularVelocity_radps;
  return state;
}

Transform stylusOnOutline() {
  return {kDeviceFromDesk * kToolFromStylus, {}};
}

ToolSetup setupOnDesk(const Transform& patientFromOutline) {
  ToolSetup setup;
  setup.stylusFromTool = Transform{transposed(kToolFromStylus), {}};
  setup.patientFromDevice = patientFromOutline * inverted(stylusOnOutline() * setup.stylusFromTool);
  return setup;
}

CameraHands::CameraHands(Open open, std::array<std::shared_ptr<PoseDevice>, 2> devices,
                         const CameraCalibration& calibration)
    : open_(std::move(open)), devices_(std::move(devices)), calibration_(calibration) {
  setPhases(DevicePhase::kOpening, {});
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

CameraHands::~CameraHands() {
  thread_.request_stop();
  thread_.join();
  setPhases(DevicePhase::kAbsent, {});
}

CameraState CameraHands::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

CameraView CameraHands::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

CameraCalibration CameraHands::calibration() const {
  const std::lock_guard lock(mutex_);
  return calibration_;
}

void CameraHands::calibrateLens() {
  const std::lock_guard lock(mutex_);
  state_.task = CameraState::Task::kLens, state_.taken = 0, state_.needed = LensCalibrator::kLeastViews;
  state_.outcome.clear();
}

void CameraHands::registerDesk() {
  constexpr int kPoses = 30;
  const std::lock_guard lock(mutex_);
  state_.task = CameraState::Task::kDesk, state_.taken = 0, state_.needed = kPoses;
  state_.outcome.clear();
}

void CameraHands::cancelTask() {
  const std::lock_guard lock(mutex_);
  state_.task = CameraState::Task::kTracking;
}

void CameraHands::end(const std::string& outcome, bool hasFailed) {
  const std::lock_guard lock(mutex_);
  state_.task = CameraState::Task::kTracking, state_.outcome = outcome, state_.hasFailed = hasFailed;
}

void CameraHands::setPhases(DevicePhase phase, const std::string& sentence) {
  for (const auto& device : devices_) {
    device->setPhase(phase, sentence);
    device->setQuality({0, 0, {}});
  }
}

void CameraHands::run(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kWait{100}, kAgain{1000};
  Work work;
  while (!stop.stop_requested()) {
    if (!work.source && !openSource(work)) {
      for (auto waited = kWait * 0; waited < kAgain && !stop.stop_requested(); waited += kWait)
        std::this_thread::sleep_for(kWait);
      continue;
    }
    const auto status = work.source->next(work.frame, kWait);
    if (status && *status == CameraStatus::kFrame) {
      take(work);
    } else if (!status || *status == CameraStatus::kEnded) {
      const std::string sentence = status ? "The recording of frames has ended." : status.error().message;
      work.source.reset();
      setPhases(DevicePhase::kLost, sentence);
      const std::lock_guard lock(mutex_);
      state_.error = sentence, state_.frames_Hz = 0;
    }
  }
}

bool CameraHands::openSource(Work& work) {
  auto source = open_();
  if (!source) {
    // A camera that worked before is lost; it comes back when it is plugged in again.
    const bool wasOpen = !state().name.empty();
    setPhases(wasOpen ? DevicePhase::kLost : DevicePhase::kFailed, source.error().message);
    const std::lock_guard lock(mutex_);
    state_.error = source.error().message;
    return false;
  }
  work = {};
  work.source = std::move(*source);
  const int width = work.source->width(), height = work.source->height();
  const auto lens = calibration().lens;
  const bool fits = lens && lens->width * height == lens->height * width;
  work.lens = fits ? scaledLens(*lens, width, height) : lensWithoutDistortion(width, height, kUsualLens_deg);
  work.track();
  setPhases(DevicePhase::kReady, {});
  const std::lock_guard lock(mutex_);
  state_.name = work.source->name(), state_.width = width, state_.height = height, state_.error.clear();
  return true;
}

void CameraHands::take(Work& work) {
  constexpr double kSmooth = 0.1;
  const std::int64_t begun_ns = cameraClock_ns();
  const CameraState before = state();
  if (before.task != CameraState::Task::kLens) work.board.reset();
  if (before.task != CameraState::Task::kDesk) work.onDesk.reset();
  if (before.task == CameraState::Task::kLens)
    takeBoard(work);
  else
    follow(work);
  const std::int64_t interval_ns = work.frame.time_ns - std::exchange(work.last_ns, work.frame.time_ns);
  const double compute_ms = double(cameraClock_ns() - begun_ns) * 1e-6;
  const std::lock_guard lock(mutex_);
  state_.compute_ms += (compute_ms - state_.compute_ms) * (state_.compute_ms > 0 ? kSmooth : 1);
  if (interval_ns <= 0) return;
  const double rate_Hz = std::min(1000.0, 1e9 / double(interval_ns));
  state_.frames_Hz += (rate_Hz - state_.frames_Hz) * (state_.frames_Hz > 0 ? kSmooth : 1);
}

void CameraHands::follow(Work& work) {
  const std::vector<TrackedHand>& hands = work.tracker->process(work.frame);
  CameraView seen;
  seen.frame = work.frame;
  for (const HapticTool hand : {kProbeTool, kNeedleTool}) {
    const TrackedHand& one = hands[std::size_t(hand)];
    seen.bodies[std::size_t(hand)] = {one.sight, one.advice, {}};
    if (one.sight == HandSight::kTracked)
      seen.bodies[std::size_t(hand)].outline =
          outlineOf(work.tracker->bodies()[std::size_t(hand)], work.lens, one.cameraFromBody);
    post(work, hand, one);
  }
  takeDesk(work, hands[kProbeTool]);
  const std::lock_guard lock(mutex_);
  view_ = std::move(seen);
}

/// Posts the pose of a body. A hidden body stays where it was last seen, at rest.
void CameraHands::post(Work& work, HapticTool hand, const TrackedHand& seen) {
  constexpr double kSmooth = 0.1;
  PoseDevice& device = *devices_[std::size_t(hand)];
  const bool isSeen = seen.sight == HandSight::kTracked;
  const bool isNews = isSeen || (seen.sight == HandSight::kHidden && !work.isHeld[std::size_t(hand)]);
  work.isHeld[std::size_t(hand)] = !isSeen;
  if (isNews) {
    DeviceState state = stateOf(seen, work.tracker->bodies()[std::size_t(hand)], calibration().cameraFromDesk);
    state.time_ns = work.frame.time_ns;
    device.post(state);
    const double latency_ms = double(cameraClock_ns() - work.frame.time_ns) * 1e-6;
    work.latency_ms += (latency_ms - work.latency_ms) * (work.latency_ms > 0 ? kSmooth : 1);
  }
  device.setQuality({isSeen ? work.latency_ms : 0, qualityOf(seen), std::string(sentenceOf(seen.advice))});
}

void CameraHands::takeBoard(Work& work) {
  if (!work.board) work.board.emplace(work.frame.width, work.frame.height);
  const BoardView view = work.board->add(work.frame);
  {
    const std::lock_guard lock(mutex_);
    view_ = {};
    view_.frame = work.frame;
    state_.taken = work.board->views();
  }
  if (view != BoardView::kTaken || work.board->views() < LensCalibrator::kLeastViews) return;
  const auto done = work.board->calibrate();
  // More images may show the board from the missing directions.
  constexpr int kMostViews = 20;
  if (!done && work.board->views() < kMostViews) return;
  if (!done) return end(done.error().message, true);
  work.lens = done->lens;
  work.track();
  {
    const std::lock_guard lock(mutex_);
    calibration_.lens = done->lens;
    calibration_.cameraFromDesk.reset();  // it was computed with the former lens
  }
  end("The lens is calibrated from " + std::to_string(done->views) + " images; the corners fit to " +
          rounded(done->error_px, 2) + " pixels.",
      false);
}

void CameraHands::takeDesk(Work& work, const TrackedHand& probe) {
  constexpr int kMostFrames = 150;
  const CameraState now = state();
  if (now.task != CameraState::Task::kDesk) return;
  if (!work.onDesk) work.onDesk.emplace(), work.deskFrames = 0;
  if (probe.sight == HandSight::kTracked) work.onDesk->push_back(probe.cameraFromMeasured);
  {
    const std::lock_guard lock(mutex_);
    state_.taken = int(work.onDesk->size());
  }
  if (int(work.onDesk->size()) < now.needed && ++work.deskFrames < kMostFrames) return;
  const auto desk = insonate::registerDesk(*work.onDesk, work.tracker->bodies()[kProbeTool].bodyFromTool);
  if (!desk) return end(desk.error().message, true);
  {
    const std::lock_guard lock(mutex_);
    calibration_.cameraFromDesk = desk->cameraFromDesk;
  }
  // The device frame is another one from now on.
  setPhases(DevicePhase::kReady, {});
  end("The desk is set: the outline is where the probe is on the patient. The probe was held still to " +
          rounded(desk->spread_mm, 1) + " mm.",
      false);
}

}  // namespace insonate
