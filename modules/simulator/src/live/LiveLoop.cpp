#include "live/LiveLoop.h"

#include <insonate/core/ThreadPriority.h>
#include <insonate/ultrasound/Display.h>

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace insonate {
namespace {

/// Number of images after which each angle has been rendered again and earlier images contribute less than half a gray
/// level.
int framesToSettle(const ImagingSetup& setup) {
  const double persistence = setup.settings.persistence;
  const auto angles = static_cast<int>(steeringAngles_deg(setup.probe, setup.settings).size());
  const double longest = std::max(persistence, setup.color ? setup.color->persistence : 0);
  return angles - 1 + (longest > 0 ? static_cast<int>(std::ceil(std::log(0.5 / 255) / std::log(longest))) : 0);
}

constexpr double kSmallScene_mm = 3;
/// Extent around the probe for which distances are computed ahead of need.
constexpr double kAhead_mm = 45;

std::span<const NamedVessel> vesselsOf(const CaseVolumes& patient) {
  return patient.vessels ? std::span<const NamedVessel>(*patient.vessels) : std::span<const NamedVessel>();
}

LiveOptions completed(LiveOptions options) {
  if (options.threads <= 0) options.threads = std::max(1, tbb::info::default_concurrency() - 1);
  options.sceneMargin_mm = std::clamp(options.sceneMargin_mm, 2.0, 100.0);
  // Margin, so that a new scene does not immediately require the next one.
  options.sceneReserve_mm = std::clamp(options.sceneReserve_mm, 0.0, 0.8 * options.sceneMargin_mm);
  return options;
}

}  // namespace

LiveImaging::Impl::Source::Source(std::shared_ptr<const ImagingSetup> of, Imager its, CompressedTissue pressed,
                                  const VolumeGeometry& volume)
    : setup(std::move(of)),
      imager(std::move(its)),
      tissue(std::move(pressed)),
      need(*setup, volume),
      framesToSettle(insonate::framesToSettle(*setup)) {}

LiveImaging::Impl::Impl(CaseVolumes patient, std::shared_ptr<const ImagingSetup> setup, Imager imager,
                        CompressedTissue tissue, const Transform& patientFromProbe, const LiveOptions& options)
    : patient_(std::move(patient)),
      options_(completed(options)),
      pulsating_(options.pulsating),
      resting_(options.paused),
      cine_(options.cineBytes),
      active_(std::move(setup), std::move(imager), std::move(tissue), patient_.labels->geometry),
      pose_(patientFromProbe),
      bubbles_(vesselsOf(patient_), patient_.labels.get()),
      physiology_(options.physiology),
      blood_(vesselsOf(patient_), patient_.labels.get()),
      builder_(patient_, options_, [this] { wake(); }),
      spectra_(blood_.model().vessels(), patient_.labels, [this] { return now_s(); }),
      thread_([this] {
        if (options_.background) lowerThreadPriority();
        tbb::task_arena arena(options_.threads);
        arena.execute([this] { run(); });
      }) {}

LiveImaging::Impl::~Impl() {
  stopping_ = true;
  builder_.cancel();
  wake();
  thread_.join();
}

void LiveImaging::Impl::wake() {
  {
    const std::lock_guard lock(wakeMutex_);
    woken_ = true;
  }
  waking_.notify_one();
}

void LiveImaging::Impl::waitFor(double seconds) {
  std::unique_lock lock(wakeMutex_);
  const auto woken = [this] { return woken_; };
  if (seconds < kNever_s)
    waking_.wait_for(lock, std::chrono::duration<double>(seconds), woken);
  else
    waking_.wait(lock, woken);
  woken_ = false;
}

void LiveImaging::Impl::run() {
  while (!stopping_) {
    double due_s = kNever_s;
    try {
      takeInputs();
      if (resting_) {
        rest();
      } else {
        takeScene();
        activateNext();
        followProbe();
        coverAtOnce();
        due_s = makeImage();
      }
    } catch (const std::exception& error) {
      next_.reset();
      setState(LiveState::Failed, "The image could not be rendered (" + std::string(error.what()) + ").");
    }
    waitFor(due_s);
  }
}

/// A setup that waits for its scene continues to wait.
void LiveImaging::Impl::rest() {
  if (!scene_.scene && !job_) return;
  builder_.rest();
  job_.reset();
  scene_ = {};
  const std::lock_guard lock(mutex_);
  status_.buildingScene = false;
}

void LiveImaging::Impl::takeInputs() {
  if (const auto pose = poses_.takeLatest()) {
    jobFailed_ = jobFailed_ && *pose == pose_;
    pose_ = *pose;
  }
  if (const auto needle = needles_.takeLatest()) needle_ = *needle;
  if (auto rods = rodChanges_.takeLatest()) rods_ = std::move(*rods);
  if (const auto flush = flushes_.takeLatest()) flush_ = *flush, flushed_s_ = now_s();
  takePneumothorax();
  if (auto setup = setups_.takeLatest()) {
    jobFailed_ = false;
    auto imager = Imager::make(**setup, CompoundingSchedule::OneAnglePerFrame);
    auto tissue = CompressedTissue::make((*setup)->probe, (*setup)->settings, (*setup)->mechanics, kIterations);
    if (imager && tissue)
      next_.emplace(std::move(*setup), std::move(*imager), std::move(*tissue), patient_.labels->geometry);
    else
      setState(LiveState::Failed, imager ? tissue.error().message : imager.error().message);
  }
  takePhysiology();
}

bool LiveImaging::Impl::suits(const live::SceneJob& job, const Source& source) {
  if (!job.setup || job.detail_mm != source.need.detail_mm()) return false;
  return job.setup == source.setup || job.setup->tissues.tissues == source.setup->tissues.tissues;
}

void LiveImaging::Impl::takeScene() {
  auto built = builder_.take();
  if (!built) return;
  job_.reset();
  if (!built->scene) {
    jobFailed_ = true;
    setState(LiveState::Failed, std::move(built->error));
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    ++status_.scenesBuilt;
    status_.sceneBuild_ms = built->build_ms;
    status_.buildingScene = false;
  }
  // Another setup replaced that of this scene while it was being delivered.
  if (!suits(built->job, next_ ? *next_ : active_)) return;
  // The probe has left it already.
  if (scene_.isCoarse() && !next_ && isCovered(active_) && !live::covers(built->job.region_mm, active_.need.at(pose_)))
    return;
  if (next_) activate(std::move(*std::exchange(next_, std::nullopt)));
  // A probe at rest gets an image of full quality, too.
  if (scene_.isCoarse()) drawn_ = false;
  scene_ = std::move(*built);
  builder_.expect(active_.need.at(pose_, kAhead_mm), active_.need.detail_mm());
}

/// A setup is applied together with its scene, so that no image mixes two.
void LiveImaging::Impl::activateNext() {
  if (!next_) return;
  const bool outside = next_->need.misses(pose_);
  if (!outside && !isCovered(*next_)) return;
  if (!suits(scene_.job, *next_)) scene_ = {};
  activate(std::move(*std::exchange(next_, std::nullopt)));
}

bool LiveImaging::Impl::isCovered(const Source& source) const {
  return suits(scene_.job, source) && live::covers(scene_.job.region_mm, source.need.at(pose_));
}

void LiveImaging::Impl::followProbe() {
  const Source& source = next_ ? *next_ : active_;
  if (jobFailed_ || source.need.misses(pose_)) return;
  if (!scene_.isCoarse() && suits(scene_.job, source) &&
      live::covers(scene_.job.region_mm, source.need.at(pose_, options_.sceneReserve_mm)))
    return;
  // A scene in work that the probe has already left would be too late.
  if (job_ && suits(*job_, source) && live::covers(job_->region_mm, source.need.at(pose_))) return;
  // If there is no scene yet, a small one is built first. This does not apply to a probe that has just moved, since it
  // would leave the small one, too.
  const bool wasLeft = job_ && suits(*job_, source);
  const bool farAway = !drawn_ || norm(pose_.offset - drawnPose_.offset) > options_.sceneMargin_mm;
  const bool small = !wasLeft && (!suits(scene_.job, source) || farAway) && !isCovered(source);
  const double room_mm = small ? std::min(kSmallScene_mm, options_.sceneMargin_mm) : options_.sceneMargin_mm;
  job_ = live::SceneJob{source.setup, source.need.at(pose_, room_mm), source.need.detail_mm(), SceneQuality::Full,
                        !isCovered(source) || scene_.isCoarse()};
  builder_.begin(*job_);
  const std::lock_guard lock(mutex_);
  status_.buildingScene = true;
}

/// A probe that has left its scene gets a coarse one, which takes little longer than an image. The scene of full
/// quality is being built meanwhile. A new setup at the same place waits for that scene, since the former image stays
/// right.
void LiveImaging::Impl::coverAtOnce() {
  const Source& source = next_ ? *next_ : active_;
  if (jobFailed_ || isFrozen() || source.need.misses(pose_) || isCovered(source) || (next_ && isCovered(active_)))
    return;
  const auto scenes = builder_.source();
  if (!scenes) return;
  const double room_mm = std::min(kSmallScene_mm, options_.sceneMargin_mm);
  auto coarse = live::buildScene(
      *scenes, {source.setup, source.need.at(pose_, room_mm), source.need.detail_mm(), SceneQuality::Coarse}, {});
  if (!coarse.scene) return;
  scene_ = std::move(coarse);
  activateNext();
  drawn_ = false;
  jumped_ = true;
}

bool LiveImaging::Impl::isFrozen() const {
  const std::lock_guard lock(mutex_);
  return frozen_;
}

double LiveImaging::Impl::makeImage() {
  const bool frozen = isFrozen();
  if (std::exchange(frozenSeen_, frozen) != frozen) notify();
  if (frozen) return kNever_s;
  const bool outside = active_.need.misses(pose_);
  const bool moved = !drawn_ || !(pose_ == drawnPose_) || (bloodChanged_ && !outside);
  if (!outside && !isCovered(active_)) {
    if (!jobFailed_) setState(number_ ? LiveState::WaitingForScene : LiveState::Starting);
    return kNever_s;
  }
  const LiveState state = outside ? LiveState::Outside : LiveState::Imaging;
  const bool changes = moved ||
                       (!outside && (!(needle_ == drawnNeedle_) || rods_ != drawnRods_ || flush_ != drawnFlush_ ||
                                     continues() || timeToNextPulse_s() <= 0)) ||
                       gateBegun_.exchange(false);
  if (!changes && (settleLeft_ == 0 || outside)) {
    if (!jobFailed_) setState(state);
    return outside ? kNever_s : timeToNextPulse_s();
  }
  const double now = now_s();
  sinceDrawn_s_ = now - std::exchange(begun_s_, now);
  if (outside)
    blackImage();
  else
    renderImage();
  if (!publish()) return kNever_s;
  settleLeft_ = changes ? active_.framesToSettle : settleLeft_ - 1;
  tissueLeft_ = moved ? kMaxOfOneSolve : tissueLeft_ - 1;
  drawn_ = true;
  drawnPose_ = pose_;
  drawnNeedle_ = needle_;
  drawnRods_ = rods_;
  drawnFlush_ = flush_;
  bloodChanged_ = false;
  if (!jobFailed_) setState(state);
  notify();
  if (outside) return settleLeft_ > 0 ? 0 : kNever_s;
  return settleLeft_ > 0 || continues() ? 0 : timeToNextPulse_s();
}

void LiveImaging::Impl::renderImage() {
  press();
  const PlaneDisplacement& pressed = active_.tissue.deformation().displacement;
  const PlaneDisplacement& seen = needle_.tenting ? tented_.addTenting(pressed, pose_, *needle_.tenting) : pressed;
  scratch_.noiseSeed = static_cast<std::uint32_t>(number_ + 1);
  if (active_.setup->color) setMotion(seen);
  if (std::exchange(jumped_, false)) active_.imager.forget();
  active_.imager.render(*scene_.scene, pose_, seen,
                        {needle_.needle ? &*needle_.needle : nullptr,
                         rods_ ? std::span(*rods_) : std::span<const FlexibleRod>(), bubblesNow()},
                        scratch_);
  if (spectra_.isOn()) showGate(seen);
  scratch_.frame_ms += press_.solve_ms;
}

void LiveImaging::Impl::blackImage() {
  if (active_.black.gray.empty()) Display(active_.setup->probe, active_.setup->settings).process({}, active_.black);
  scratch_.image = active_.black;
  scratch_.color.width = scratch_.color.height = 0;
  scratch_.envelope.resize(0, 0, 0);
  scratch_.stages.clear();
  scratch_.frame_ms = 0;
  active_.tissue.release();
  press_ = {};
  if (!spectra_.isOn()) return;
  live::GateMoment nothing;
  nothing.setup = active_.setup;
  spectra_.show(std::move(nothing));
}

/// False if the image was too late, because imaging has been frozen.
bool LiveImaging::Impl::publish() {
  static const auto kNoWarnings = std::make_shared<const std::vector<std::string>>();
  std::shared_ptr<LiveFrame> frame = pool_->acquire();
  // The former buffers of the frame receive the next image.
  std::swap(frame->image, scratch_.image);
  std::swap(frame->color, scratch_.color);
  std::swap(frame->stages, scratch_.stages);
  if (options_.keepEnvelopes) std::swap(frame->envelope, scratch_.envelope);
  frame->patientFromProbe = pose_;
  frame->needle = needle_.needle;
  frame->rods = rods_, frame->flush = flush_;
  describePress(frame->press);
  frame->trachea_mm = scene_.scene ? std::optional(scene_.scene->trachea_mm()) : std::nullopt;
  frame->setup = active_.setup;
  frame->isCoarse = scene_.isCoarse() && !active_.need.misses(pose_);
  frame->warnings = scene_.warnings ? scene_.warnings : kNoWarnings;
  frame->frame_ms = scratch_.frame_ms;
  frame->engine = scratch_.engine, frame->engineNote = scratch_.engineNote;
  frame->number = number_ + 1;
  frame->time_s = now_s();

  const std::lock_guard lock(mutex_);
  if (frozen_) return false;
  times_s_[number_ % times_s_.size()] = frame->time_s;
  ++number_;
  cine_.push(std::move(frame));
  return true;
}

void LiveImaging::Impl::setState(LiveState state, std::string message) {
  {
    const std::lock_guard lock(mutex_);
    if (status_.state == state && status_.message == message) return;
    status_.state = state;
    status_.message = std::move(message);
    if (state == LiveState::Failed) status_.buildingScene = false;
  }
  notify();
}

void LiveImaging::Impl::notify() {
  const std::lock_guard lock(listenerMutex_);
  if (listener_) listener_();
}

}  // namespace insonate
