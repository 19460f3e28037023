#include "AttemptControl.h"

#include "../model/Disclosure.h"
#include "../model/TrainModel.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/simulator/AttemptOrigin.h>
#include <insonate/simulator/ProcedureFit.h>
#include <insonate/ui/Attempts.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QSettings>
#include <QThreadPool>
#include <algorithm>
#include <chrono>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kLook_ms = 100;
/// For a store that does not answer.
constexpr int kSealWait_ms = 3000;

template <class T>
bool isThere(const T& future) {
  return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

AttemptControl::AttemptControl(TrainModel& model, QString folder, QObject* parent)
    : QObject(parent), model_(model), folder_(std::move(folder)) {
  if (folder_.isEmpty()) folder_ = ui::attemptsFolder();
  // They come with the program.
  for (const std::string& name : procedurePresetNames())
    if (auto procedure = builtInProcedure(name)) procedures_.push_back(std::move(*procedure));
  choose("internal_jugular");  // until a case is open
  timer_.setInterval(kLook_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
  connect(&model_.patientCase, &CaseModel::caseChanged, this, [this] {
    hash_ = {};
    close();
  });
  connect(&model_.patientCase, &CaseModel::structuresKnown, this, &AttemptControl::chooseFitting);
  connect(&model_.live, &LiveModel::pictureShown, this, [this] {
    if (!hash_.valid()) hashCase();
  });
  connect(&model_.live, &LiveModel::frozenChanged, this, [this] {
    if (isRunning())
      attempt_->recordEvent(model_.live.isFrozen() ? AttemptEventKind::Frozen : AttemptEventKind::Released);
  });
  connect(&model_.hands, &HapticControl::needleChanged, this, [this] {
    // The syringe is on the needle.
    if (aspirating_ && !model_.hands.needle()) setAspirating(false);
  });
  connect(&model_.imaging, &ImagingModel::tissueChanged, this, [this] {
    const double tilt_deg = model_.imaging.tissue().body.tilt_deg;
    if (std::exchange(tilt_deg_, tilt_deg) != tilt_deg && isRunning())
      attempt_->recordEvent(AttemptEventKind::Positioned, tilt_deg);
    settingsChanged();
  });
  connect(&model_.imaging, &ImagingModel::setupChanged, this, [this] { settingsChanged(); });
}

AttemptControl::~AttemptControl() {
  close();
  if (state_ == State::Writing) conclude(writing_.get());
}

/// Dragging changes settings with each frame: they are recorded ten times a second.
void AttemptControl::settingsChanged() {
  if (!isRunning() || !model_.live.shown()) return;
  settingsDue_ = sinceSettings_.isValid() && sinceSettings_.elapsed() < kLook_ms;
  if (!settingsDue_) keepSettings();
}

void AttemptControl::keepSettings() {
  settingsDue_ = false;
  sinceSettings_.start();
  AttemptSettings now = model_.live.attemptSettings();
  now.bloodTime_s = bloodTime_s_;
  attempt_->setSettings(now);
}

void AttemptControl::choose(const std::string& procedure) {
  const auto found = std::ranges::find(procedures_, procedure, &Procedure::name);
  if (found == procedures_.end() || isRunning()) return;
  const auto chosen = std::size_t(found - procedures_.begin());
  if (std::exchange(chosen_, chosen) != chosen) Q_EMIT stateChanged();
}

void AttemptControl::chooseFitting() {
  const auto fits = [this](const Procedure& one) {
    return checkProcedureFits(one, model_.patientCase.patient()->manifest, *model_.patientCase.structures())
        .has_value();
  };
  // A level states its procedure itself.
  if (isBusy() || !obstacle_.isEmpty() || fits(procedure())) return;
  if (const auto found = std::ranges::find_if(procedures_, fits); found != procedures_.end()) choose(found->name);
}

void AttemptControl::setAssistance(Assistance assistance) {
  if (isRunning() || std::exchange(assistance_, assistance) == assistance) return;
  Q_EMIT stateChanged();
}

QString AttemptControl::unfit() const {
  if (!obstacle_.isEmpty()) return obstacle_;
  if (!model_.patientCase.patient() || !model_.patientCase.structures()) return {};
  const auto fits =
      checkProcedureFits(procedure(), model_.patientCase.patient()->manifest, *model_.patientCase.structures());
  return fits ? QString() : QString::fromStdString(fits.error().message);
}

void AttemptControl::setObstacle(const QString& why) {
  if (std::exchange(obstacle_, why) != why) Q_EMIT stateChanged();
}

/// After the first image, which nothing is to delay.
void AttemptControl::hashCase() {
  const auto task = std::make_shared<std::packaged_task<std::string()>>(
      [patient = model_.patientCase.patient()] { return voxelHashOf(*patient); });
  hash_ = task->get_future().share();
  QThreadPool::globalInstance()->start([task] { (*task)(); });
}

void AttemptControl::close() {
  again_ = false;
  setAspirating(false);
  if (isRunning()) write(AttemptStatus::Abandoned);
  isClosed_ = state_ == State::Writing;
  if (!isClosed_ && state_ != State::Idle) show(State::Idle);
}

/// Ends the recording on a thread of its own; look() shows the result.
void AttemptControl::write(AttemptStatus status) {
  model_.hands.setAttempt(nullptr);
  status_ = status;
  writing_ = std::async(std::launch::async, [attempt = attempt_, status] { return attempt->finish(status); });
  show(State::Writing);
}

void AttemptControl::show(State state) {
  state_ = state;
  isBusy() ? timer_.start() : timer_.stop();
  disclose();
  Q_EMIT stateChanged();
}

void AttemptControl::disclose() {
  const bool isHidden = hidesBefore_ && state_ == State::Idle;
  Disclosure now = disclosureOf(assistance_, isHidden || state_ == State::Starting || state_ == State::Running);
  now.otherPlaces = !isHidden;
  model_.disclosure.set(now);
}

void AttemptControl::hideAnatomyBefore(bool on) {
  if (std::exchange(hidesBefore_, on) != on) disclose();
}

void AttemptControl::start() {
  if (isBusy()) return;
  if (!obstacle_.isEmpty()) return model_.status.showMessage(obstacle_);
  if (!model_.live.shown() || !model_.motion.isReady() || !model_.patientCase.structures())
    return model_.status.showMessage(tr("Wait for the first image; then the attempt can begin."));
  if (const QString why = unfit(); !why.isEmpty()) return model_.status.showMessage(why);
  model_.live.setFrozen(false);
  // A new needle, ready to be taken up.
  model_.hands.removeNeedle();
  Q_EMIT needleReplaced();
  whose_ = {}, key_.reset(), sealIsDue_ = false;
  sinceStart_.start();
  show(State::Starting);
  Q_EMIT starting();
  look();
}

void AttemptControl::setSeal(const RecordedFor& whose, const std::optional<RecordKey>& key) {
  if (state_ != State::Starting) return;
  whose_ = whose, key_ = key, sealIsDue_ = false;
}

std::filesystem::path AttemptControl::newFile() const {
  QString plain = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HHmmss ")) +
                  QString::fromStdString(model_.patientCase.patient()->manifest.title).simplified().left(60);
  for (QChar& one : plain)
    if (!one.isLetterOrNumber() && one != QLatin1Char('-')) one = QLatin1Char(' ');
  const auto path = [&](int number) {
    const QString more = number > 1 ? QStringLiteral(" %1").arg(number) : QString();
    return std::filesystem::path(QDir(folder_).filePath(plain + more + ui::kAttemptSuffix).toStdString());
  };
  // Two may begin within a second.
  int number = 1;
  while (std::filesystem::exists(path(number)) || std::filesystem::exists(AttemptRecorder::partialFile(path(number))))
    ++number;
  return path(number);
}

void AttemptControl::begin() {
  const QString title = QCoreApplication::applicationName() + QLatin1Char(' ') + QCoreApplication::applicationVersion();
  header_ = headerOf(procedure(), *model_.patientCase.patient(), model_.imaging.probe(), title.toStdString());
  VesselLocator vessels(model_.patientCase.patient()->manifest, procedure(), model_.motion.targetNear_mm());
  header_.vessels = vessels.names();
  header_.caseHash = hash_.get();
  const AttemptSettings settings = model_.live.attemptSettings();
  bloodTime_s_ = settings.bloodTime_s;
  header_.engine = settings.setup.engine;
  header_.settings = textOf(settings);
  header_.recordedFor = whose_;
  header_.hands = {model_.hands.kindOfHand(kProbeTool), model_.hands.kindOfHand(kNeedleTool)};
  auto started = QDir().mkpath(folder_) ? LiveAttempt::start(newFile(), header_, procedure(), std::move(vessels), key_)
                                        : fail("The folder " + folder_.toStdString() +
                                               " for attempts cannot be made; check that you may " + "write there.");
  if (!started) {
    show(State::Idle);
    return model_.status.showMessage(QString::fromStdString(started.error().message));
  }
  attempt_ = std::move(*started);
  if (hasLine(procedure()))
    if (const auto line = attempt_->prepareLine(model_.patientCase.patient()->manifest.vessels); !line) {
      attempt_ = nullptr;
      show(State::Idle);
      return model_.status.showMessage(QString::fromStdString(line.error().message));
    }
  error_.clear();
  view_ = attempt_->view();
  tilt_deg_ = model_.imaging.tissue().body.tilt_deg;
  if (tilt_deg_ != 0) attempt_->recordEvent(AttemptEventKind::Positioned, tilt_deg_);
  attempt_->setAspirating(aspirating_);
  model_.hands.setAttempt(attempt_);
  show(State::Running);
  Q_EMIT begun();
  model_.status.showMessage(assistance_ == Assistance::Test
                                ? tr("The test has begun. Ctrl+Return finishes the test.")
                                : tr("The attempt has begun. Ctrl+Return finishes the attempt."));
  Q_EMIT viewChanged();
}

void AttemptControl::perform(LineAct act, int lumen) {
  if (!isRunning()) return;
  const auto done = attempt_->perform(act, lumen);
  if (!done)
    model_.status.showMessage(QString::fromStdString(done.error().message));
  else if (act == LineAct::MeasurePressure)
    model_.status.showMessage(tr("Pressure at the hub: %1 mmHg.").arg(*done, 0, 'f', 0));
  else if (act == LineAct::FlushForBubbles)
    model_.status.showMessage(tr("Saline is flushed. Look for bubbles in the vein, from the tip toward the heart."));
  else if (act == LineAct::DetachSyringe)
    setAspirating(false);
  look();
}

double AttemptControl::moveInstrument(Instrument instrument, double by_mm) {
  if (!isRunning()) return 0;
  const InstrumentMove move = attempt_->moveInstrument(instrument, by_mm);
  if (!move.refusal.empty()) model_.status.showMessage(QString::fromStdString(move.refusal));
  look();
  return move.moved_mm;
}

void AttemptControl::end(AttemptStatus status) {
  if (!isRunning()) return;
  setAspirating(false);
  if (settingsDue_) keepSettings();
  write(status);
}

void AttemptControl::conclude(const Result<MetricValues>& kept) {
  file_ = kept ? QString::fromStdString(attempt_->file().string()) : QString();
  view_ = attempt_->view();
  score_ = attempt_->score();
  if (!kept) model_.status.showMessage(QString::fromStdString(kept.error().message));
  Q_EMIT ended();
}

void AttemptControl::startAgain() {
  if (isRunning()) {
    again_ = true;
    return abandon();
  }
  model_.live.setFrozen(false);
  model_.motion.home();
  start();
}

void AttemptControl::leave() {
  if (state_ == State::Over) show(State::Idle);
}

void AttemptControl::look() {
  if (state_ == State::Starting) {
    if (!hash_.valid()) hashCase();
    const bool isSealed = !sealIsDue_ || sinceStart_.elapsed() > kSealWait_ms;
    // Without tissue, a needle would go through vein and artery without a puncture.
    const bool hasTissue = model_.hands.session().isTissueGridReady();
    return isThere(hash_) && isSealed && hasTissue ? begin() : void();
  }
  if (!attempt_) return;
  if (settingsDue_ && isRunning()) keepSettings();
  view_ = attempt_->view();
  if (const std::string error = attempt_->error(); error != error_) {
    error_ = error;
    model_.status.showMessage(QString::fromStdString(error));
  }
  if (state_ == State::Writing && isThere(writing_)) {
    conclude(writing_.get());
    show(std::exchange(isClosed_, false) ? State::Idle : State::Over);
    if (std::exchange(again_, false)) startAgain();
  }
  Q_EMIT viewChanged();
}

void AttemptControl::setAspirating(bool on) {
  if (on && !model_.hands.needle()) {
    model_.status.showMessage(tr("Take the needle before you aspirate: the syringe is on the needle."));
    Q_EMIT aspiratingChanged();  // a button that was pressed is released
    return;
  }
  if (on && isRunning() && hasLine(procedure()) && !view_.line.isSyringeOn) {
    model_.status.showMessage(tr("The syringe is off. Attach it before you aspirate."));
    Q_EMIT aspiratingChanged();
    return;
  }
  if (std::exchange(aspirating_, on) == on) return;
  if (isRunning()) attempt_->setAspirating(on);
  Q_EMIT aspiratingChanged();
}

void AttemptControl::replaceNeedle() {
  const auto& held = model_.hands.needle();
  if (held && held->state.inBody)
    return model_.status.showMessage(tr("Withdraw the needle from the skin before you take a new needle."));
  if (isRunning()) attempt_->recordEvent(AttemptEventKind::NeedleReplaced);
  setAspirating(false);
  Q_EMIT needleReplaced();
  const bool isOnDevice = held && !model_.hands.needleHand();
  if (!isOnDevice) model_.needle.take(model_.hands.needlePlane());
  model_.status.showMessage(tr("You now have a new needle."));
}

void AttemptControl::save(QSettings& settings) const {
  settings.setValue("procedure", QString::fromStdString(procedure().name));
  settings.setValue("assistance", int(assistance_));
}

void AttemptControl::restore(QSettings& settings) {
  choose(settings.value("procedure").toString().toStdString());
  setAssistance(Assistance(std::clamp(settings.value("assistance").toInt(), 0, int(Assistance::Test))));
}

}  // namespace insonate::train
