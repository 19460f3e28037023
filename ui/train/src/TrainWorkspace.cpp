#include "attempt/AttemptFeature.h"
#include "devices/DevicesFeature.h"
#include "doppler/DopplerFeature.h"
#include "image/ImageExports.h"
#include "image/ImageFeature.h"
#include "layout/LayoutFeature.h"
#include "layout/TrainLayout.h"
#include "levels/LevelsFeature.h"
#include "line/LineFeature.h"
#include "link/LinkFeature.h"
#include "model/TrainModel.h"
#include "needle/NeedleFeature.h"
#include "patient3d/Patient3dFeature.h"
#include "probe/ProbeFeature.h"
#include "tissue/TissueFeature.h"
#include "trace/TraceFeature.h"
#include "undo/UndoFeature.h"

#include <insonate/train/TrainBenchmark.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/ViewWidget.h>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <algorithm>
#include <utility>

namespace insonate::train {
namespace {

/// All words of the three columns have room from here on.
constexpr int kRoomy_px = 1260;

}  // namespace

TrainWorkspace::TrainWorkspace(QWidget* parent)
    : ui::Workspace(parent), model_(new TrainModel(this)), layout_(std::make_unique<TrainLayout>(*this)) {
  setObjectName("train");
  ui::CanvasInput::of(*layout_->views().imageWidget().focusProxy()).add(ui::InputRank::Observer, *this);
  addFeatures();
  layout_->assemble();
  connectModel();
  model_->live.setAwake(false);
}

/// The order is that of the sections in the left column and, reversed, of the actions in the View menu; settings are
/// restored in it, and signals of the model arrive in it.
void TrainWorkspace::addFeatures() {
  auto& attempt = add<AttemptFeature>();
  add<LevelsFeature>(attempt.control(), attempt.panel());
  devices_ = &add<DevicesFeature>();
  auto& probe = add<ProbeFeature>();
  add<NeedleFeature>(devices_->panelAction());
  add<LineFeature>(attempt.control());
  add<LayoutFeature>();
  exports_ = &add<ImageFeature>(probe.chooser()).exports();
  add<LinkFeature>();
  add<DopplerFeature>();
  add<TraceFeature>();
  add<TissueFeature>();
  patient_ = &add<Patient3dFeature>().patientViews();
  add<UndoFeature>();
}

template <class T, class... Parts>
T& TrainWorkspace::add(Parts&... parts) {
  auto* feature = new T(*model_, *layout_, parts...);
  connect(feature, &Feature::caseReleased, this, [this] { takeSavedCase(); });
  features_.push_back(feature);
  return *feature;
}

void TrainWorkspace::connectModel() {
  connect(&model_->patientCase, &CaseModel::caseChanged, this, [this] {
    error_.clear();
    checkReady();
  });
  connect(&model_->live, &LiveModel::pictureShown, this, [this] { checkReady(); });
  connect(&model_->motion, &ProbeMotion::placingChanged, this, [this] { checkReady(); });
  connect(&model_->patientCase, &CaseModel::surfacesDone, this, &Workspace::readyChanged);
  connect(&model_->status, &StatusLine::messageChanged, this, &Workspace::statusChanged);
  connect(&model_->engine, &EngineText::changed, this, &Workspace::statusChanged);
  connect(&model_->patientCase, &CaseModel::failed, this, [this](const QString& what) {
    error_ = what;
    reportProblem();
  });
}

TrainWorkspace::~TrainWorkspace() {
  stop();
  benchmark_ = nullptr;
  for (Feature* feature : std::exchange(features_, {})) delete feature;
  // The widgets refer to the model, which is deleted after them.
  layout_ = nullptr;
}

void TrainWorkspace::setOpeningText(const QString& what) {
  for (Feature* feature : features_) feature->setOpeningText(what);
}

void TrainWorkspace::setAccount(ui::Account& account) {
  for (Feature* feature : features_) feature->setAccount(account);
}

void TrainWorkspace::setOrigin(const ui::CaseOrigin& origin) {
  origin_ = origin;
}

void TrainWorkspace::setCase(std::shared_ptr<const PatientCase> patient) {
  savedCase_ = nullptr;
  model_->patientCase.setCase(std::move(patient), origin_);
}

void TrainWorkspace::caseSaved(std::shared_ptr<const PatientCase> patient) {
  savedCase_ = std::move(patient);
  takeSavedCase();
  if (savedCase_)
    model_->status.showMessage(
        tr("The case was saved in Prepare. This attempt continues with the former version of the case."));
}

/// Replaces the case by its saved state: now, or once no feature holds it.
void TrainWorkspace::takeSavedCase() {
  if (!savedCase_ || std::ranges::any_of(features_, &Feature::holdsCase)) return;
  model_->patientCase.setCase(std::exchange(savedCase_, nullptr), origin_);
}

void TrainWorkspace::setHands(ui::HandsChoice choice) {
  devices_->setHands(choice);
}

QString TrainWorkspace::statusText() const {
  return model_->status.message();
}

QString TrainWorkspace::engineNote() const {
  const auto frame = model_->live.shown();
  return frame ? QString::fromStdString(frame->engineNote) : QString();
}

QString TrainWorkspace::engineText() const {
  return model_->engine.text();
}

QString TrainWorkspace::interruptionWarning() const {
  for (const Feature* feature : features_)
    if (QString what = feature->interruptionWarning(); !what.isEmpty()) return what;
  return {};
}

QString TrainWorkspace::workspaceChangeBlocker() const {
  if (model_->disclosure.current().anatomy) return {};
  return tr(
      "A test is in progress. Prepare and Review would show where the vessels are; end the attempt before you open "
      "them.");
}

bool TrainWorkspace::isReady() const {
  return isReady_;
}

bool TrainWorkspace::isComplete() const {
  return isReady_ && !isCoarse_ && model_->patientCase.surfacesThere();
}

/// Without an image, the offer to place the probe is all there is to see.
void TrainWorkspace::checkReady() {
  const bool isReady = model_->live.shown() || (model_->patientCase.patient() && model_->motion.isUnplaced());
  const bool isCoarse = model_->live.shown() && model_->live.shown()->isCoarse;
  const bool changed = isReady != isReady_ || isCoarse != isCoarse_;
  isReady_ = isReady, isCoarse_ = isCoarse;
  if (changed) Q_EMIT readyChanged();
}

/// Reports why there is no image, once the user sees the workspace: during labeling the problem does not concern Train.
void TrainWorkspace::reportProblem() {
  if (error_.isEmpty() || !isVisible()) return;
  Q_EMIT failed(std::exchange(error_, {}), tr("Check the case in Prepare, or open another case."), {});
}

void TrainWorkspace::saveLayout(QSettings& settings) const {
  for (const Feature* feature : features_) feature->save(settings);
}

void TrainWorkspace::restoreLayout(QSettings& settings) {
  for (Feature* feature : features_) feature->restore(settings);
  // Restoring the last session's state must not be undoable.
  model_->history.clear();
}

void TrainWorkspace::stop() {
  for (Feature* feature : features_) feature->stop();
  model_->patientCase.stop();
}

void TrainWorkspace::saveImage(const std::filesystem::path& file) {
  exports_->saveImage(file);
}

void TrainWorkspace::saveScreen(const std::filesystem::path& file) {
  exports_->saveScreen(file);
}

void TrainWorkspace::saveClip(const std::filesystem::path& target) {
  exports_->saveClip(target);
}

TrainBenchmark& TrainWorkspace::benchmark() {
  if (!benchmark_) benchmark_ = std::make_unique<TrainBenchmark>(*model_, layout_->views().imageWidget(), *patient_);
  return *benchmark_;
}

/// Gives the image the keyboard focus when the pointer enters it.
bool TrainWorkspace::eventFilter(QObject* watched, QEvent* event) {
  // Without a layout, the views are being deleted.
  if (event->type() == QEvent::Enter && layout_) takeKeyboard();
  return ui::Workspace::eventFilter(watched, event);
}

void TrainWorkspace::takeKeyboard() {
  // A field in which the user types keeps the keyboard focus.
  QWidget* holder = QApplication::focusWidget();
  const bool typing = qobject_cast<QLineEdit*>(holder) || qobject_cast<QAbstractSpinBox*>(holder);
  if (isActiveWindow() && !typing) layout_->views().imageWidget().setFocus(Qt::MouseFocusReason);
}

void TrainWorkspace::resizeEvent(QResizeEvent* event) {
  for (Feature* feature : features_) feature->setCompact(width() < kRoomy_px);
  ui::Workspace::resizeEvent(event);
}

void TrainWorkspace::showEvent(QShowEvent* event) {
  model_->live.setAwake(true);
  model_->live.setWatched(!layout_->isPageShown());
  ui::Workspace::showEvent(event);
  reportProblem();
}

void TrainWorkspace::hideEvent(QHideEvent* event) {
  model_->live.setWatched(false);
  model_->live.setAwake(std::ranges::any_of(features_, &Feature::needsImages));
  ui::Workspace::hideEvent(event);
}

void TrainWorkspace::keyPressEvent(QKeyEvent* event) {
  if (!commands().key(*event, true)) ui::Workspace::keyPressEvent(event);
}

}  // namespace insonate::train
