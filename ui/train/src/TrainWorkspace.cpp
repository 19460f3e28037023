#include "TrainParts.h"
#include "attempt/AttemptControl.h"
#include "devices/DevicePanel.h"
#include "feature/KeyTable.h"
#include "image/export/ImageExports.h"
#include "panel/ControlsPanel.h"
#include "patient3d/PatientViews.h"
#include "tissue/TissueShown.h"

#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/ScenePanel.h>

#include <QKeyEvent>
#include <QSettings>
#include <QSplitter>
#include <algorithm>
#include <utility>

namespace insonate::train {
namespace {

/// All words of the three columns have room from here on.
constexpr int kRoomy_px = 1260;

}  // namespace

TrainWorkspace::TrainWorkspace(QWidget* parent) : ui::Workspace(parent), parts_(std::make_unique<Parts>(*this)) {
  setObjectName("train");
  parts_->model.live.setAwake(false);
}

TrainWorkspace::~TrainWorkspace() {
  parts_->endAttempt();
  parts_->model.patientCase.stop();
  // It waits for the recording, whose end the other parts hear of.
  delete std::exchange(parts_->attempt, nullptr);
  parts_->releaseCanvases();
  // The widgets refer to the model: they go first.
  delete parts_->devices;
  delete parts_->columns;
}

void TrainWorkspace::setOpening(const QString& what) {
  parts_->showOpening(what);
}

void TrainWorkspace::setAccount(ui::Account& account) {
  parts_->setAccount(account);
}

void TrainWorkspace::setOrigin(const ui::CaseOrigin& origin) {
  parts_->origin = origin;
}

void TrainWorkspace::setCase(std::shared_ptr<const PatientCase> patient) {
  parts_->setCase(std::move(patient));
}

void TrainWorkspace::caseSaved(std::shared_ptr<const PatientCase> patient) {
  parts_->takeSaved(std::move(patient));
}

QString TrainWorkspace::statusText() const {
  return parts_->model.status.message();
}

QString TrainWorkspace::engineNote() const {
  const auto frame = parts_->model.live.shown();
  return frame ? QString::fromStdString(frame->engineNote) : QString();
}

QString TrainWorkspace::engineText() const {
  return parts_->engineText;
}

bool TrainWorkspace::isComplete() const {
  return parts_->ready && parts_->model.patientCase.surfacesThere();
}

QString TrainWorkspace::endsWithTheCase() const {
  if (!parts_->attempt->isRunning()) return {};
  return tr("An attempt is in progress in Train. Continuing ends it and saves it as abandoned.");
}

QString TrainWorkspace::blocksWorkspaceChange() const {
  if (parts_->model.disclosure.current().anatomy) return {};
  return tr("A test is in progress: Prepare and Review would show where the vessels are. End the attempt first.");
}

bool TrainWorkspace::isReady() const {
  return parts_->ready;
}

std::vector<ui::Shortcut> TrainWorkspace::shortcuts() const {
  std::vector<ui::Shortcut> all;
  for (const KeyRow& row : keyTable())
    if (*row.keys) all.push_back({tr(row.keys), tr(row.meaning)});
  for (const MouseRow& row : mouseTable()) all.push_back({tr(row.gesture), tr(row.meaning)});
  return all;
}

void TrainWorkspace::saveLayout(QSettings& settings) const {
  settings.setValue("leftHanded", parts_->isLeftHanded());
  settings.setValue("ctBeside", parts_->isCtBeside());
  parts_->exports->save(settings);
  settings.setValue("labelOpacity", parts_->patient->mpr().labelOpacity());
  const bool allSlices = parts_->patient->showsAllSlices();
  // Four slices take their room again when they are back.
  parts_->patient->setAllSlices(false);
  settings.setValue("columns", parts_->columns->saveState());
  settings.setValue("patientViews", parts_->patient->splitter().saveState());
  parts_->patient->setAllSlices(allSlices);
  settings.setValue("slice", int(parts_->patient->mpr().kind()));
  settings.setValue("allSlices", allSlices);
  settings.beginGroup("scene");
  parts_->patient->scenePanel().save(settings);
  settings.endGroup();
  parts_->panel->save(settings);
  parts_->tissue->save(settings);
  settings.beginGroup("attempt");
  parts_->attempt->save(settings);
  settings.endGroup();
}

void TrainWorkspace::restoreLayout(QSettings& settings) {
  // First the order, then the widths.
  parts_->setLeftHanded(settings.value("leftHanded", false).toBool());
  parts_->setCtBeside(settings.value("ctBeside", false).toBool());
  parts_->exports->restore(settings);
  parts_->patient->mpr().setLabelOpacity(settings.value("labelOpacity", 0).toDouble());
  parts_->columns->restoreState(settings.value("columns").toByteArray());
  parts_->patient->splitter().restoreState(settings.value("patientViews").toByteArray());
  const int slice = settings.value("slice", int(views::SliceKind::Oblique)).toInt();
  parts_->patient->setSliceKind(views::SliceKind(std::clamp(slice, 0, int(views::SliceKind::Oblique))));
  if (settings.value("allSlices", false).toBool()) parts_->patient->setAllSlices(true);
  settings.beginGroup("scene");
  parts_->patient->scenePanel().restore(settings);
  settings.endGroup();
  parts_->panel->restore(settings);
  parts_->tissue->restore(settings);
  settings.beginGroup("attempt");
  parts_->attempt->restore(settings);
  settings.endGroup();
  // Restoring the last session's state must not be undoable.
  parts_->model.history.clear();
}

void TrainWorkspace::stop() {
  parts_->endAttempt();
  parts_->model.patientCase.stop();
}

void TrainWorkspace::savePicture(const std::filesystem::path& file) {
  parts_->exports->savePicture(file);
}

void TrainWorkspace::saveScreen(const std::filesystem::path& file) {
  parts_->exports->saveScreen(file);
}

void TrainWorkspace::saveClip(const std::filesystem::path& folder) {
  parts_->exports->saveClip(folder);
}

void TrainWorkspace::measureHands(double seconds, std::function<void(HandRates)> done) {
  parts_->measureHands(seconds, std::move(done));
}

void TrainWorkspace::measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done) {
  parts_->measureLive(seconds, viewsFollow, std::move(done));
}

OrbitRates TrainWorkspace::measureOrbit(int steps) {
  return parts_->measureOrbit(steps);
}

void TrainWorkspace::measureVolume(double seconds, std::function<void(VolumeRates)> done) {
  parts_->measureVolume(seconds, std::move(done));
}

bool TrainWorkspace::eventFilter(QObject* watched, QEvent* event) {
  return parts_->canvasEvent(watched, event) || ui::Workspace::eventFilter(watched, event);
}

void TrainWorkspace::resizeEvent(QResizeEvent* event) {
  parts_->setCompact(width() < kRoomy_px);
  ui::Workspace::resizeEvent(event);
}

void TrainWorkspace::showEvent(QShowEvent* event) {
  parts_->model.live.setAwake(true);
  parts_->model.live.setWatched(!parts_->isCourseShown());
  ui::Workspace::showEvent(event);
  parts_->reportProblem();
}

void TrainWorkspace::hideEvent(QHideEvent* event) {
  parts_->model.live.setWatched(false);
  parts_->model.live.setAwake(parts_->attempt->isRunning());
  ui::Workspace::hideEvent(event);
}

void TrainWorkspace::keyPressEvent(QKeyEvent* event) {
  if (!parts_->key(*event, true)) ui::Workspace::keyPressEvent(event);
}

}  // namespace insonate::train
