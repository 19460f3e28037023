#include "LivePatient.h"

#include <insonate/cases/TissueLabels.h>
#include <insonate/simulator/ImagePlace.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/AcousticTable.h>

#include <QFutureWatcher>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>

namespace insonate::prepare {
namespace {

/// Size of the small image, with as many scanlines as its columns can show.
constexpr int kScanlines = 160, kSamples = 500, kWidth = 410, kHeight = 308;
/// Delay until the slices are painted: on two processors they would wait for the image, and for the probe in 3D.
constexpr int kAfterSlices_ms = 40;
/// Only the latest image is needed.
constexpr std::size_t kCineBytes = std::size_t{4} << 20;

ImagingSetup smallSetup() {
  // All presets are compiled in.
  ImagingSetup setup;
  setup.probe = loadProbe("linear").value_or(Probe{});
  setup.settings = settingsFor(setup.probe);
  setup.settings.scanlines = kScanlines, setup.settings.samples = kSamples;
  setup.settings.width = kWidth, setup.settings.height = kHeight;
  setup.tissues = loadAcousticTable(acousticPresetNames().front()).value_or(AcousticTable{});
  return setup;
}

}  // namespace

LivePatient::LivePatient(QObject* parent) : QObject(parent), setup_(smallSetup()), feed_([this] { news(); }) {
  showing_.setSingleShot(true);
  showing_.setInterval(kAfterSlices_ms);
  showing_.callOnTimeout(this, [this] { moved(); });
}

LivePatient::~LivePatient() {
  stop();
}

void LivePatient::stop() {
  worker_ = nullptr;
  showing_.stop();
  forgetTissues();
  feed_.setImaging(nullptr);
}

void LivePatient::setPatient(std::shared_ptr<const PatientCase> patient, std::vector<ui::SurfaceRequest> wishes) {
  stop();
  patient_ = std::move(patient);
  labels_ = nullptr;
  ++skin_;
  start_.reset(), hand_.reset(), wanted_mm_.reset();
  press_mm_ = 0;
  shown_ = nullptr;
  status_ = {};
  error_.clear();
  surfacesDone_ = true;
  if (patient_) makeWorker(std::move(wishes), true);
  Q_EMIT stateChanged();
}

void LivePatient::makeWorker(std::vector<ui::SurfaceRequest> wishes, bool withHand) {
  ui::CaseCallbacks work;
  if (withHand) {
    work.start = [this](StartPose pose) {
      if (start_) return;
      start_ = std::move(pose);
      startLive();
      Q_EMIT started();
      Q_EMIT poseChanged();
    };
    work.hand = [this](ProbePlacement hand) {
      // The probe stands on the skin, from which the start pose may differ slightly.
      takeHand(std::move(hand));
      moved();
      if (wanted_mm_) follow(*wanted_mm_);
    };
    work.unplaced = [this](ProbePlacement hand, const QString&) {
      takeHand(std::move(hand));
      startLive();
      Q_EMIT poseChanged();
      if (wanted_mm_) follow(*wanted_mm_);
    };
  }
  work.surface = [this](std::uint8_t label, std::shared_ptr<const Mesh> mesh) { Q_EMIT surfaceMade(label, mesh); };
  work.surfacesDone = [this] {
    surfacesDone_ = true;
    Q_EMIT stateChanged();
  };
  work.failed = [this](const QString& text) {
    error_ = text;
    Q_EMIT stateChanged();
  };
  surfacesDone_ = false;
  worker_ = std::make_unique<ui::CaseWorker>(patient_, std::move(work), std::move(wishes));
}

void LivePatient::replacePatient(std::shared_ptr<const PatientCase> patient) {
  patient_ = std::move(patient);
  // A busy worker keeps the old voxels until it has finished.
  if (surfacesDone_ && worker_) makeWorker({}, !hand_);
  if (feed_.imaging()) startLive();
}

void LivePatient::wantSurface(const ui::SurfaceRequest& wish) {
  if (!worker_) return;
  surfacesDone_ = false;
  worker_->requestSurfaces({wish});
}

/// Takes some tenths of a second on another thread; until then the probe stays on the former skin.
void LivePatient::findSkin() {
  using HapticTool = std::shared_ptr<const ProbePlacement>;
  auto* found = new QFutureWatcher<HapticTool>(this);
  connect(found, &QFutureWatcher<HapticTool>::finished, this, [this, found, number = ++skin_] {
    found->deleteLater();
    const HapticTool hand = found->result();
    if (number != skin_ || !hand || !hand_) return;
    hand_ = *hand;
    // The probe keeps its direction and moves to the present skin. It may have been moved meanwhile.
    hand_->setPose(chosen_->pose);
    hand_->press(chosen_->press_mm - std::max(hand_->state().press_mm, 0.0));
    moved();
  });
  found->setFuture(QtConcurrent::run([labels = labels_, pose = chosen_->pose]() -> HapticTool {
    auto hand = ProbePlacement::make(*labels, pose);
    return hand ? std::make_shared<const ProbePlacement>(std::move(*hand)) : nullptr;
  }));
}

void LivePatient::setLabels(std::shared_ptr<const LabelMap> labels, std::vector<ui::SurfaceRequest> wishes,
                            bool outsideMoved) {
  labels_ = std::move(labels);
  if (outsideMoved && hand_) findSkin();
  if (outsideMoved && !hand_ && worker_) {
    surfacesDone_ = false;
    worker_->place(labels_);
  }
  for (const ui::SurfaceRequest& wish : wishes) wantSurface(wish);
  if (feed_.imaging()) startLive();
}

void LivePatient::setOwnLabels(const OwnLabels& own) {
  bool otherTissues = false;
  for (int label = kLabelCount; label < 256; ++label)
    otherTissues = otherTissues || tissueOf(own, std::uint8_t(label)) != tissueOf(own_, std::uint8_t(label));
  own_ = own;
  if (otherTissues && feed_.imaging()) startLive();
}

void LivePatient::setAwake(bool awake) {
  if (awake == awake_) return;
  awake_ = awake;
  stale_ = false;
  if (awake) {
    startLive();
  } else {
    forgetTissues();
    feed_.setImaging(nullptr);
  }
  Q_EMIT stateChanged();
}

std::optional<Transform> LivePatient::pose() const {
  auto pose = standing();
  if (pose) pose->offset = pose->offset + press_mm_ * pose->linear.column[2];
  return pose;
}

std::optional<Transform> LivePatient::standing() const {
  if (hand_) return hand_->pose();
  if (!start_) return std::nullopt;
  const auto pose = patientFromProbe(start_->position_mm, start_->axial, start_->lateral);
  return pose ? std::optional(*pose) : std::nullopt;
}

void LivePatient::forgetTissues() {
  ++tissues_;
  tissuesDue_ = false;
}

void LivePatient::startLive() {
  if (!awake_ || !patient_ || !pose()) return;
  forgetTissues();
  auto labels = labels_ ? labels_ : CaseVolumes(patient_).labels;
  if (own_.empty()) return startLiveOf(std::move(labels));
  // Reads a map of the whole case: some tenths of a second on a busy computer.
  tissuesDue_ = true;
  using Map = std::shared_ptr<const LabelMap>;
  auto* made = new QFutureWatcher<Map>(this);
  connect(made, &QFutureWatcher<Map>::finished, this, [this, made, number = tissues_] {
    made->deleteLater();
    if (number != tissues_) return;
    tissuesDue_ = false;
    startLiveOf(made->result());
  });
  made->setFuture(
      QtConcurrent::run([own = own_, labels = std::move(labels)] { return withTissueLabels(own, labels); }));
}

void LivePatient::startLiveOf(std::shared_ptr<const LabelMap> tissues) {
  LiveOptions options;
  options.cineBytes = kCineBytes;
  // Each edit would discard a scene prepared ahead; a small scene is ready soon enough.
  options.workAhead = false;
  // Slices have precedence, but not over the first image of a case, for which the author waits: on a busy computer, a
  // thread of low priority would need minutes.
  options.background = shown_ != nullptr;
  auto live = LiveImaging::make(CaseVolumes(patient_, std::move(tissues)), setup_, *pose(), options);
  if (!live) {
    error_ = QString::fromStdString(live.error().message);
    feed_.setImaging(nullptr);
  } else {
    feed_.setImaging(std::move(*live));
    stale_ = true;
  }
  Q_EMIT stateChanged();
}

void LivePatient::news() {
  if (!feed_.imaging()) return;
  status_ = feed_.imaging()->status();
  auto frame = feed_.imaging()->latest();
  if (frame && frame != shown_) {
    shown_ = std::move(frame);
    stale_ = false;
    Q_EMIT pictureShown();
  }
  Q_EMIT stateChanged();
}

void LivePatient::follow(Vec3 patient_mm) {
  wanted_mm_ = patient_mm;
  if (!hand_) return;
  hand_->placeAt(patient_mm, rotation_deg_);
  rememberPlace();
  // During a drag of the crosshair, further moves do not delay the update.
  if (!showing_.isActive()) showing_.start();
}

void LivePatient::setPress(double mm) {
  press_mm_ = mm;
  if (hand_) moved();
}

void LivePatient::setStart(std::optional<StartPose> start) {
  start_ = std::move(start);
  Q_EMIT stateChanged();
}

void LivePatient::goTo(const StartPose& place) {
  wanted_mm_.reset();
  if (!hand_) return;
  if (const auto pose = patientFromProbe(place.position_mm, place.axial, place.lateral)) hand_->setPose(*pose);
  rotation_deg_ = rotationOf_deg(hand_->state());
  rememberPlace();
  moved();
}

void LivePatient::takeHand(ProbePlacement hand) {
  hand_ = std::move(hand);
  rotation_deg_ = rotationOf_deg(hand_->state());
  error_.clear();
  rememberPlace();
}

void LivePatient::rememberPlace() {
  chosen_ = Chosen{hand_->pose(), std::max(hand_->state().press_mm, 0.0)};
}

void LivePatient::moved() {
  showing_.stop();
  if (feed_.imaging()) feed_.imaging()->setPose(*pose());
  Q_EMIT poseChanged();
}

bool LivePatient::isOfFormerPlace() const {
  const auto now = pose();
  if (!shown_ || !now) return false;
  const bool follows = status_.state == LiveState::Imaging || status_.state == LiveState::Outside;
  return !showsPlaceOf(*shown_, *now) || (!follows && shown_->patientFromProbe != *now);
}

bool LivePatient::isSettled() const {
  if (!patient_) return true;
  if (!surfacesDone_ || tissuesDue_ || showing_.isActive()) return false;
  if (!error_.isEmpty() || status_.state == LiveState::Failed) return true;
  return shown_ && !stale_ && !shown_->isCoarse && pose() && shown_->patientFromProbe == *pose();
}

QString LivePatient::state() const {
  if (!patient_) return {};
  if (!error_.isEmpty()) return error_;
  if (status_.state == LiveState::Failed) return QString::fromStdString(status_.message);
  if (status_.state == LiveState::Outside) return tr("The probe is outside the scan.");
  if (!isBuilding()) return {};
  if (tissuesDue_) return tr("Reading the tissues of your own labels ...");
  if (!feed_.imaging()) return tr("Finding the skin under the start pose ...");
  return tr("Building the scene: properties of the tissue around the probe ...");
}

bool LivePatient::isBuilding() const {
  if (!patient_ || !awake_ || !error_.isEmpty()) return false;
  if (tissuesDue_ || !feed_.imaging()) return true;
  return status_.state == LiveState::Starting || status_.state == LiveState::WaitingForScene;
}

}  // namespace insonate::prepare
