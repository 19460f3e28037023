#include "ReviewSession.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/simulator/AttemptOrigin.h>
#include <insonate/simulator/ImagePlace.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/TaskBar.h>

#include <QFileInfo>
#include <QPointer>
#include <QtConcurrent/QtConcurrent>
#include <algorithm>
#include <utility>

namespace insonate::review {
namespace {

constexpr int kTick_ms = 33;
/// Number of triangles with which 3D follows the replay without a graphics card.
const std::vector<ui::SurfaceRequest> kSurfaces = {{kVein, {4, 1}}, {kArtery, {4, 1}}, {kSkin, {8, 3}},
                                                   {kBone, {5, 2}}, {kAirway, {5, 2}}, {kThyroid, {5, 1.5}}};

}  // namespace

ReviewSession::ReviewSession(QObject* parent) : QObject(parent) {
  timer_.setInterval(kTick_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  connect(&picture_, &ReplayImage::changed, this, &ReviewSession::pictureShown);
}

ReviewSession::~ReviewSession() {
  stop();
}

void ReviewSession::stop() {
  setPlaying(false);
  surfaces_ = nullptr;
  shownPatient_ = nullptr;
  picture_.set(nullptr, nullptr);
}

void ReviewSession::open(const QString& file, ui::TaskBar& tasks) {
  using Digest = std::shared_ptr<const AttemptDigest>;
  setPlaying(false);
  opening_ = true;
  Q_EMIT openingChanged();
  QPointer<ReviewSession> self(this);
  tasks.run<Digest>(
      tr("Opening %1").arg(QFileInfo(file).fileName()),
      [file](const Progress& progress) { return digestOf(file.toStdString(), progress); },
      [self, round = ++round_](Result<Digest> digest) {
        if (!self || round != self->round_) return;
        self->opening_ = false;
        if (digest) self->take(std::move(*digest));
        Q_EMIT self->openingChanged();
        if (!digest && digest.error().message != kCancelled)
          Q_EMIT self->failed(QString::fromStdString(digest.error().message),
                              tr("The attempt that was open before stays open. To replay, choose another attempt."));
      });
}

void ReviewSession::close() {
  ++round_;
  if (std::exchange(opening_, false)) Q_EMIT openingChanged();
  take(nullptr);
}

void ReviewSession::take(std::shared_ptr<const AttemptDigest> attempt) {
  setPlaying(false);
  attempt_ = std::move(attempt);
  reader_.reset();
  if (attempt_) reader_.emplace(attempt_->recording);
  time_us_ = 0;
  Q_EMIT attemptChanged();
  match();
  show();
}

void ReviewSession::setPatient(std::shared_ptr<const PatientCase> patient) {
  if (patient == patient_) return;
  patient_ = std::move(patient);
  hash_.clear();
  match();
  show();
}

void ReviewSession::match() {
  const CaseFit before = fit_;
  if (!attempt_ || !patient_) {
    fit_ = CaseFit::Missing;
  } else if (patient_->manifest.title != attempt_->recording->header().caseName) {
    fit_ = CaseFit::Other;
  } else if (hash_.isEmpty() && !attempt_->recording->header().caseHash.empty()) {
    fit_ = CaseFit::Looking;
    if (before == CaseFit::Looking) return;
    QPointer<ReviewSession> self(this);
    (void)QtConcurrent::run([self, patient = patient_] {
      const QString hash = QString::fromStdString(voxelHashOf(*patient));
      QMetaObject::invokeMethod(qApp, [self, patient, hash] {
        if (self) self->hashed(patient, hash);
      });
    });
  } else {
    fit_ = hash_.toStdString() == attempt_->recording->header().caseHash ? CaseFit::Same : CaseFit::Changed;
  }
  startPatient();
  Q_EMIT caseChanged();
  Q_EMIT messageChanged();
}

void ReviewSession::hashed(const std::shared_ptr<const PatientCase>& patient, const QString& hash) {
  fit_ = CaseFit::Missing;
  if (patient == patient_) hash_ = hash;
  match();
  show();
}

void ReviewSession::setAwake(bool awake) {
  if (std::exchange(awake_, awake) == awake) return;
  if (!awake) setPlaying(false);
  startPatient();
  show();
}

/// Surfaces are computed once for a patient; the renderer of images is released while the workspace is hidden.
void ReviewSession::startPatient() {
  const auto patient = attempt_ && fits() ? patient_ : nullptr;
  picture_.set(attempt_ && awake_ ? attempt_->recording : nullptr, patient);
  if (!awake_ || patient == shownPatient_) return;
  shownPatient_ = patient;
  surfaces_ = nullptr;
  if (!patient) return;
  ui::CaseCallbacks work;
  work.surface = [this](std::uint8_t label, std::shared_ptr<const Mesh> mesh) { Q_EMIT surfaceMade(label, mesh); };
  work.surfacesDone = [this] {
    surfacesDone_ = true;
    Q_EMIT surfacesDone();
  };
  work.failed = [this](const QString& text) { Q_EMIT failed(text, {}); };
  surfacesDone_ = false;
  surfaces_ = std::make_unique<ui::CaseWorker>(patient, std::move(work), kSurfaces);
}

void ReviewSession::setTime(std::int64_t time_us) {
  time_us = std::clamp(time_us, std::int64_t{0}, attempt_ ? attempt_->end_us : 0);
  if (time_us == time_us_) return;
  time_us_ = time_us;
  show();
}

void ReviewSession::stepMoment(int by) {
  if (!attempt_) return;
  const auto& all = attempt_->moments;
  if (by > 0) {
    const auto next = std::ranges::upper_bound(all, time_us_, {}, &AttemptMoment::time_us);
    if (next != all.end()) setTime(next->time_us);
  } else {
    const auto here = std::ranges::lower_bound(all, time_us_, {}, &AttemptMoment::time_us);
    if (here != all.begin()) setTime(std::prev(here)->time_us);
  }
}

void ReviewSession::show() {
  sample_ = reader_ ? reader_->at(time_us_) : std::nullopt;
  picture_.want(sample_ ? std::max(time_us_, sample_->time_us) : time_us_);
  Q_EMIT timeChanged();
}

bool ReviewSession::isImageStale() const {
  const auto& frame = picture_.shown();
  if (!frame || picture_.isSettled()) return false;
  const bool held = sample_ && sample_->patientFromProbe;
  return picture_.isOfAnotherMoment() || !held || !showsPlaceOf(*frame, *sample_->patientFromProbe);
}

AttemptDigest::PlaceChange ReviewSession::needle() const {
  return attempt_ ? attempt_->placeAt(time_us_) : AttemptDigest::PlaceChange{};
}

void ReviewSession::setPlaying(bool playing) {
  if (playing == isPlaying() || (playing && !attempt_)) return;
  if (playing) {
    if (time_us_ >= attempt_->end_us) setTime(0);
    clock_.start();
    timer_.start();
  } else {
    timer_.stop();
  }
  Q_EMIT playingChanged();
}

void ReviewSession::setSpeed(double speed) {
  if (std::exchange(speed_, speed) != speed) Q_EMIT playingChanged();
}

void ReviewSession::tick() {
  step(double(clock_.restart()) / 1000 * speed_);
  if (time_us_ >= attempt_->end_us) setPlaying(false);
}

bool ReviewSession::isSettled() const {
  if (!attempt_) return !opening_;
  return fit_ != CaseFit::Looking && surfacesThere() && picture_.isSettled();
}

QString ReviewSession::message() const {
  if (!attempt_) return {};
  const QString name = QString::fromStdString(attempt_->recording->header().caseName);
  switch (fit_) {
    case CaseFit::Missing:
      return tr("This attempt was made on case '%1'. Open that case (Ctrl+O) to see hand movements and images.")
          .arg(name);
    case CaseFit::Other:
      return tr("This attempt was made on case '%1', not on the open case. Open the attempt's case (Ctrl+O) to see "
                "hand movements and images.")
          .arg(name);
    case CaseFit::Changed:
      return tr("Case '%1' has changed since this attempt. Hand movements are shown on the present version of the "
                "case, without images.")
          .arg(name);
    case CaseFit::Looking:
    case CaseFit::Same:
      break;
  }
  if (!attempt_->errors.empty()) return QString::fromStdString(attempt_->errors.front());
  return tr("Space plays the attempt. Click on the timeline to go to a time; Page Up and Page Down go to key moments.");
}

}  // namespace insonate::review
