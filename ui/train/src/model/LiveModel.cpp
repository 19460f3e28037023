#include "LiveModel.h"

#include "CaseModel.h"
#include "HapticControl.h"
#include "ImagingModel.h"
#include "StatusLine.h"

#include <insonate/cases/CaseView.h>
#include <insonate/cases/HeartDistance.h>
#include <insonate/simulator/ImagePlace.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/NeedleTable.h>

#include <algorithm>
#include <utility>

namespace insonate::train {

LiveModel::LiveModel(CaseModel& patientCase, ImagingModel& imaging, HapticControl& hands, StatusLine& status,
                     QObject* parent)
    : QObject(parent), case_(patientCase), imaging_(imaging), hands_(hands), status_(status), feed_([this] {
        news();
      }) {
  connect(&case_, &CaseModel::stopping, this, [this] { stop(); });
  connect(&case_, &CaseModel::emptied, this, [this] { empty(); });
  connect(&case_, &CaseModel::caseShown, this, [this] {
    if (std::exchange(wasFrozen_, false)) Q_EMIT frozenChanged();
  });
  connect(&case_, &CaseModel::startKnown, this, [this] { start(); });
  connect(&case_, &CaseModel::failed, this, [this](const QString& why) { failure_ = why.toStdString(); });
  connect(&imaging_, &ImagingModel::setupChanged, this, [this] { sendSetup(); });
  connect(&imaging_, &ImagingModel::physiologyChanged, this, [this] { updateTissueRequest(); });
  connect(&hands_, &HapticControl::pedalPressed, this, [this](int button) {
    if (button == 0) setFrozen(!frozen_);
  });
}

LiveModel::~LiveModel() {
  stop();
}

void LiveModel::stop() {
  hands_.session().setImaging(nullptr);
  feed_.setImaging(nullptr);
}

void LiveModel::empty() {
  hands_.setHeld(false);
  shown_ = nullptr;
  cine_.clear();
  cineIndex_ = 0;
  failure_.clear();
  checkStale();
  wasFrozen_ = std::exchange(frozen_, false);
}

void LiveModel::start() {
  const StartPose& start = case_.start();
  const auto pose = patientFromProbe(start.position_mm, start.axial, start.lateral);
  if (!pose) return status_.showMessage(QString::fromStdString(pose.error().message));
  auto live =
      LiveImaging::make(CaseVolumes(case_.patient(), case_.tissueLabels()), imaging_.setup(), *pose, liveOptions());
  if (!live) return case_.fail(QString::fromStdString(live.error().message));
  pose_ = *pose;
  feed_.setImaging(std::move(*live));
  hands_.session().setImaging(feed_.imaging());
  if (gate_) feed_.imaging()->setGate(gate_);
  updateTissueRequest();
}

void LiveModel::setGate(const std::optional<SpectralSettings>& gate) {
  gate_ = gate;
  if (feed_.imaging()) feed_.imaging()->setGate(gate);
}

void LiveModel::takeSpectra(std::vector<LiveSpectrum>& spectra) {
  if (feed_.imaging()) return feed_.imaging()->takeSpectra(spectra);
  spectra.clear();
}

void LiveModel::sendSetup() {
  if (!feed_.imaging()) return;
  if (auto ok = feed_.imaging()->setSetup(imaging_.setup()); !ok)
    status_.showMessage(QString::fromStdString(ok.error().message));
}

void LiveModel::setPose(const Transform& patientFromProbe) {
  pose_ = patientFromProbe;
  if (feed_.imaging()) feed_.imaging()->setPose(patientFromProbe);
  checkStale();
}

/// The imaging thread needs a moment to see that its scene does not contain a new pose. A pose far from the image is
/// therefore compared at once.
void LiveModel::checkStale() {
  bool stale = false;
  if (shown_ && !frozen_ && feed_.imaging()) {
    const Transform& now = hands_.drivesProbe() ? hands_.drivenPose() : pose_;
    const LiveState state = feed_.imaging()->status().state;
    const bool follows = state == LiveState::Imaging || state == LiveState::Outside;
    stale = !showsPlaceOf(*shown_, now) || (!follows && shown_->patientFromProbe != now);
  }
  if (std::exchange(stale_, stale) != stale) Q_EMIT staleChanged();
}

bool LiveModel::checkLive() {
  if (frozen_) status_.showMessage(tr("The image is frozen. Space makes it live again."));
  return !frozen_;
}

void LiveModel::news() {
  if (!feed_.imaging()) return;
  const LiveStatus now = feed_.imaging()->status();
  if (now.message != failure_) {
    failure_ = now.message;
    if (!failure_.empty()) status_.showMessage(QString::fromStdString(failure_));
  }
  if (!frozen_) show(feed_.imaging()->latest());
  checkStale();
}

void LiveModel::show(std::shared_ptr<const LiveFrame> frame) {
  if (!frame || frame == shown_) return;
  const bool first = !shown_;
  shown_ = std::move(frame);
  if (first)
    status_.showMessage(tr("Drag on the image to slide the probe; + compresses, - releases. Press ? for all keys."));
  Q_EMIT pictureShown();
  if (!first) return;
  case_.wantSurfaces();
  Q_EMIT firstShown();
}

void LiveModel::setFrozen(bool frozen) {
  if (frozen == frozen_ || !feed_.imaging() || !shown_) return;
  if (frozen && stale_)
    return status_.showMessage(tr("The image of the present position is not ready yet. Freeze it when it is shown."));
  feed_.imaging()->setFrozen(frozen);
  hands_.setHeld(frozen);
  frozen_ = frozen;
  cine_ = frozen ? feed_.imaging()->cine(kCine_s) : decltype(cine_){};
  cineIndex_ = std::max(0, int(cine_.size()) - 1);
  Q_EMIT frozenChanged();
  status_.showMessage(frozen ? tr("The image is frozen. Comma and Period show earlier and later images.")
                             : tr("The image is live."));
  show(frozen && !cine_.empty() ? cine_.back() : feed_.imaging()->latest());
  checkStale();
}

void LiveModel::showCine(int index) {
  if (!frozen_ || cine_.empty()) return;
  cineIndex_ = std::clamp(index, 0, int(cine_.size()) - 1);
  show(cine_[cineIndex_]);
}

LiveStatus LiveModel::status() const {
  return feed_.imaging() ? feed_.imaging()->status() : LiveStatus{};
}

double LiveModel::imagesPerSecond() const {
  return feed_.imaging() ? feed_.imaging()->imagesPerSecond() : 0;
}

bool LiveModel::pulsates() const {
  return watched_ && (imaging_.tissue().pulse || imaging_.tissue().breathing);
}

/// The chosen physiology at the site that the case shows.
Physiology LiveModel::physiology() const {
  Physiology all = physiologyOf(imaging_.tissue());
  if (const auto patient = case_.patient()) all.siteAboveHeart_mm = siteAboveHeart_mm(patient->manifest);
  return all;
}

LiveOptions LiveModel::liveOptions() const {
  LiveOptions options;
  options.physiology = physiology();
  options.pulsating = pulsates();
  options.paused = !awake_;
  return options;
}

AttemptSettings LiveModel::attemptSettings() const {
  AttemptSettings all;
  all.setup = imaging_.setup();
  all.setup.engine = shown_->engine;
  all.physiology = physiology();
  all.pulsating = pulsates();
  all.bloodTime_s = shown_->time_s;
  all.needle = needlePresetNames().front();
  return all;
}

void LiveModel::setMeshRequested(bool wanted) {
  if (std::exchange(meshRequested_, wanted) != wanted) updateTissueRequest();
}

void LiveModel::setWatched(bool watched) {
  hands_.setWatched(watched);
  if (std::exchange(watched_, watched) != watched) updateTissueRequest();
}

void LiveModel::setAwake(bool awake) {
  awake_ = awake;
  if (feed_.imaging()) feed_.imaging()->setPaused(!awake);
}

void LiveModel::updateTissueRequest() {
  LiveImaging* live = feed_.imaging();
  if (!live) return;
  live->setKeepMesh(meshRequested_ && watched_);
  live->setPulsating(pulsates());
  // Also where it is the same: a probe at rest then makes an image with its mesh.
  if (auto ok = live->setPhysiology(physiology()); !ok) status_.showMessage(QString::fromStdString(ok.error().message));
}

}  // namespace insonate::train
