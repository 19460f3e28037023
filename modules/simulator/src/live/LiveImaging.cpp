#include "RigidPose.h"
#include "live/LiveLoop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate {
namespace {

Result<void> checkVolumes(const CaseVolumes& patient) {
  if (!patient.ct || !patient.labels || patient.ct->voxels.empty() || patient.labels->voxels.empty())
    return fail("There is no case to image; open a case first.");
  if (!sameGrid(patient.ct->geometry, patient.labels->geometry) ||
      patient.ct->voxels.size() != patient.labels->voxels.size())
    return fail("The CT and the label map are on different grids. Resample one to the grid of the other.");
  return {};
}

/// Fails under the same conditions as Imager::make, without making an imager.
Result<void> checkSetup(const ImagingSetup& setup) {
  if (auto ok = validate(setup.probe); !ok) return ok;
  if (auto ok = validate(setup.settings, setup.probe); !ok) return ok;
  if (auto engine = makeEngine(setup.engine); !engine) return tl::unexpected(engine.error());
  if (setup.color)
    if (auto ok = validate(*setup.color, setup.probe, setup.settings); !ok) return ok;
  return validate(setup.mechanics);
}

}  // namespace

void LiveImaging::Impl::setPose(const Transform& patientFromProbe) {
  if (!isRigid(patientFromProbe)) return;
  poses_.post(patientFromProbe);
  wake();
}

void LiveImaging::Impl::setNeedle(const std::optional<Needle>& needle, const std::optional<Tenting>& tenting) {
  if (needle && !validate(*needle)) return;
  if (tenting && !(isFinite(tenting->tip_mm) && isFinite(tenting->direction) && std::isfinite(tenting->depth_mm) &&
                   std::isfinite(tenting->radius_mm)))
    return;
  needles_.post({needle, tenting});
  wake();
}

void LiveImaging::Impl::setRods(SharedRods rods) {
  if (rods && !std::ranges::all_of(*rods, [](const FlexibleRod& rod) { return validate(rod).has_value(); })) return;
  rodChanges_.post(rods);
  wake();
}

void LiveImaging::Impl::setFlush(const std::optional<SalineFlush>& flush) {
  flushes_.post(flush);
  wake();
}

void LiveImaging::Impl::setPneumothorax(const std::array<bool, 2>& lungs) {
  pneumothoraces_.post(lungs);
  wake();
}

void LiveImaging::Impl::setSetup(std::shared_ptr<const ImagingSetup> setup) {
  setups_.post(setup);
  wake();
}

void LiveImaging::Impl::setFrozen(bool frozen) {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(frozen_, frozen) == frozen) return;
  }
  spectra_.setRunning(!frozen && !resting_);
  wake();
}

void LiveImaging::Impl::setPaused(bool paused) {
  if (resting_.exchange(paused) == paused) return;
  spectra_.setRunning(!paused && !isFrozen());
  wake();
}

std::shared_ptr<const LiveFrame> LiveImaging::Impl::latest() const {
  const std::lock_guard lock(mutex_);
  return cine_.latest();
}

std::vector<std::shared_ptr<const LiveFrame>> LiveImaging::Impl::cine(double seconds) const {
  const std::lock_guard lock(mutex_);
  return cine_.last(seconds);
}

void LiveImaging::Impl::setFrameListener(std::function<void()> listener) {
  const std::lock_guard lock(listenerMutex_);
  listener_ = std::move(listener);
}

double LiveImaging::Impl::imagesPerSecond() const {
  const double since_s = now_s() - 1;
  const std::lock_guard lock(mutex_);
  return static_cast<double>(std::ranges::count_if(times_s_, [&](double t_s) { return t_s > since_s; }));
}

LiveStatus LiveImaging::Impl::status() const {
  const std::lock_guard lock(mutex_);
  LiveStatus status = status_;
  if (frozen_) status.state = LiveState::Frozen;
  return status;
}

LiveImaging::LiveImaging(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LiveImaging::~LiveImaging() = default;

Result<std::unique_ptr<LiveImaging>> LiveImaging::make(CaseVolumes patient, const ImagingSetup& setup,
                                                       const Transform& patientFromProbe, const LiveOptions& options) {
  if (auto ok = checkVolumes(patient); !ok) return tl::unexpected(ok.error());
  if (!isRigid(patientFromProbe))
    return fail(
        "The probe's pose is not a rotation with a position. Use a pose from patientFromProbe() or a start pose.");
  if (auto ok = checkPhysiology(options.physiology); !ok) return tl::unexpected(ok.error());
  auto imager = Imager::make(setup, CompoundingSchedule::OneAnglePerFrame);
  if (!imager) return tl::unexpected(imager.error());
  auto tissue = CompressedTissue::make(setup.probe, setup.settings, setup.mechanics, Impl::kIterations);
  if (!tissue) return tl::unexpected(tissue.error());
  auto shared = std::make_shared<const ImagingSetup>(setup);
  return std::unique_ptr<LiveImaging>(new LiveImaging(std::make_unique<Impl>(
      std::move(patient), std::move(shared), std::move(*imager), std::move(*tissue), patientFromProbe, options)));
}

void LiveImaging::setPose(const Transform& patientFromProbe) {
  impl_->setPose(patientFromProbe);
}

void LiveImaging::setNeedle(const std::optional<Needle>& needle, const std::optional<Tenting>& tenting) {
  impl_->setNeedle(needle, tenting);
}

void LiveImaging::setRods(SharedRods rods) {
  impl_->setRods(std::move(rods));
}

void LiveImaging::setFlush(const std::optional<SalineFlush>& flush) {
  impl_->setFlush(flush);
}

void LiveImaging::setPneumothorax(const std::array<bool, 2>& lungs) {
  impl_->setPneumothorax(lungs);
}

Result<void> LiveImaging::setSetup(const ImagingSetup& setup) {
  if (auto ok = checkSetup(setup); !ok) return ok;
  impl_->setSetup(std::make_shared<const ImagingSetup>(setup));
  return {};
}

Result<void> LiveImaging::setPhysiology(const Physiology& physiology) {
  if (auto ok = checkPhysiology(physiology); !ok) return ok;
  impl_->setPhysiology(physiology);
  return {};
}

void LiveImaging::setPulsating(bool pulsating) {
  impl_->setPulsating(pulsating);
}

void LiveImaging::setGate(const std::optional<SpectralSettings>& gate) {
  impl_->setGate(gate);
}

void LiveImaging::takeSpectra(std::vector<LiveSpectrum>& spectra) {
  impl_->takeSpectra(spectra);
}

void LiveImaging::setKeepMesh(bool keep) {
  impl_->setKeepMesh(keep);
}

void LiveImaging::setFrozen(bool frozen) {
  impl_->setFrozen(frozen);
}

void LiveImaging::setPaused(bool paused) {
  impl_->setPaused(paused);
}

std::shared_ptr<const LiveFrame> LiveImaging::latest() const {
  return impl_->latest();
}

std::vector<std::shared_ptr<const LiveFrame>> LiveImaging::cine(double seconds) const {
  return impl_->cine(seconds);
}

void LiveImaging::setFrameListener(std::function<void()> listener) {
  impl_->setFrameListener(std::move(listener));
}

double LiveImaging::imagesPerSecond() const {
  return impl_->imagesPerSecond();
}

LiveStatus LiveImaging::status() const {
  return impl_->status();
}

}  // namespace insonate
