#include "case/CaseFeature.h"
#include "check/CheckFeature.h"
#include "editing/EditingFeature.h"
#include "guide/GuideFeature.h"
#include "labels/LabelFollowers.h"
#include "labels/LabelSession.h"
#include "layout/CaseViews.h"
#include "layout/LayoutFeature.h"
#include "layout/PrepareLayout.h"
#include "live/LiveFeature.h"
#include "model/CaseChanges.h"
#include "model/CaseMeasuring.h"
#include "model/LivePatient.h"
#include "model/OpenCase.h"
#include "model/PrepareModel.h"
#include "model/StatusLine.h"
#include "places/PlacesFeature.h"
#include "publish/PublishFeature.h"
#include "recipe/RecipeFeature.h"
#include "recovery/RecoveryFeature.h"
#include "structures/StructuresFeature.h"
#include "tools/ToolsFeature.h"
#include "vessel/VesselFeature.h"
#include "viewing/SceneFeature.h"
#include "viewing/SlicesFeature.h"

#include <insonate/prepare/PrepareBenchmark.h>
#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/ui/EmptyWorkspace.h>

#include <QKeyEvent>
#include <utility>

namespace insonate::prepare {

PrepareWorkspace::PrepareWorkspace(ui::TaskBar& tasks, QWidget* parent)
    : ui::Workspace(parent),
      model_(std::make_unique<PrepareModel>(makePrepareModel(tasks, *this))),
      layout_(std::make_unique<PrepareLayout>(*this, *model_)) {
  setObjectName(QStringLiteral("prepare"));
  setTasks(tasks);
  addFeatures();
  layout_->assemble();
  connectModel();
}

/// The order is that of sections and pages in the columns and of sections in the list of keys; settings are restored in
/// it, and signals of the model arrive in it.
void PrepareWorkspace::addFeatures() {
  case_ = &add<CaseFeature>();
  add<SlicesFeature>();
  add<LayoutFeature>();
  add<RecipeFeature>();
  auto& scene = add<SceneFeature>();
  auto& tools = add<ToolsFeature>(scene.histogram());
  tools_ = &tools.tools();
  add<VesselFeature>();
  add<GuideFeature>(tools.section());
  add<StructuresFeature>();
  add<CheckFeature>();
  add<PlacesFeature>();
  add<PublishFeature>();
  add<EditingFeature>();
  add<LiveFeature>();
  recovery_ = &add<RecoveryFeature>();
}

template <class T, class... Parts>
T& PrepareWorkspace::add(Parts&... parts) {
  auto* feature = new T(*model_, *layout_, parts...);
  features_.push_back(feature);
  return *feature;
}

void PrepareWorkspace::connectModel() {
  const auto check = [this] { checkReady(); };
  connect(&model_->openCase, &OpenCase::caseChanged, this, check);
  connect(&model_->measuring, &CaseMeasuring::changed, this, check);
  connect(&model_->live, &LivePatient::stateChanged, this, check);
  connect(&model_->live, &LivePatient::stateChanged, this, &Workspace::statusChanged);
  connect(&model_->followers, &LabelFollowers::restChanged, this, check);
  connect(&model_->labeling, &LabelSession::busyChanged, this, check);
  layout_->views().setRested(check);
  connect(&model_->changes, &CaseChanges::changed, this, &Workspace::editsChanged);
  connect(&model_->statusLine, &StatusLine::changed, this, &Workspace::statusChanged);
}

PrepareWorkspace::~PrepareWorkspace() {
  stop();
  benchmark_ = nullptr;
  // The widgets refer to the features, and both to the model, which is deleted last.
  layout_ = nullptr;
  for (Feature* feature : std::exchange(features_, {})) delete feature;
}

void PrepareWorkspace::addOpenAction(QAction* action) {
  layout_->empty().addOpenAction(action);
}

void PrepareWorkspace::setCaseActions(QAction* open, QAction* import, QAction* reload) {
  case_->setCaseActions(open, import, reload);
}

void PrepareWorkspace::keepUnsavedWorkIn(const QString& folder) {
  recovery_->keepIn(folder);
}

void PrepareWorkspace::setOpeningText(const QString& what) {
  layout_->empty().showOpening(what);
}

void PrepareWorkspace::setOrigin(const ui::CaseOrigin& origin) {
  model_->openCase.setOrigin(origin);
}

void PrepareWorkspace::setCase(std::shared_ptr<const PatientCase> patient) {
  model_->openCase.setCase(std::move(patient));
}

ui::CaseEdit PrepareWorkspace::unsavedEdit() const {
  return model_->changes.unsavedEdit();
}

ui::CaseEdit PrepareWorkspace::unpromptedEdit() const {
  return model_->changes.unpromptedEdit();
}

void PrepareWorkspace::caseSaved(std::shared_ptr<const PatientCase> patient) {
  model_->openCase.replaceCase(std::move(patient));
}

QString PrepareWorkspace::statusText() const {
  return model_->statusLine.text();
}

QString PrepareWorkspace::engineText() const {
  for (const Feature* feature : features_)
    if (QString text = feature->engineText(); !text.isEmpty()) return text;
  return {};
}

bool PrepareWorkspace::isReady() const {
  return isReady_;
}

void PrepareWorkspace::checkReady() {
  // The views are being deleted.
  if (!layout_) return;
  using State = CaseMeasuring::State;
  const State state = model_->measuring.state();
  const bool isReady = model_->openCase.patient() && (state == State::Done || state == State::Stopped) &&
                       model_->live.isSettled() && layout_->views().isAtRest() && model_->followers.isAtRest() &&
                       !model_->labeling.isBusy();
  if (std::exchange(isReady_, isReady) != isReady) Q_EMIT readyChanged();
}

void PrepareWorkspace::saveLayout(QSettings& settings) const {
  for (const Feature* feature : features_) feature->save(settings);
}

void PrepareWorkspace::restoreLayout(QSettings& settings) {
  for (Feature* feature : features_) feature->restore(settings);
}

PrepareBenchmark& PrepareWorkspace::benchmark() {
  if (!benchmark_) benchmark_ = std::make_unique<PrepareBenchmark>(*model_, *tools_, layout_->views());
  return *benchmark_;
}

void PrepareWorkspace::stop() {
  model_->measuring.setAllowed(false);
  model_->live.stop();
}

/// Performs the keys of commands for a canvas (PrepareLayout::offerKeys).
bool PrepareWorkspace::eventFilter(QObject*, QEvent* event) {
  return commands().handleKeyEvent(*event);
}

void PrepareWorkspace::keyPressEvent(QKeyEvent* event) {
  if (!commands().key(*event, true)) ui::Workspace::keyPressEvent(event);
}

void PrepareWorkspace::showEvent(QShowEvent* event) {
  ui::Workspace::showEvent(event);
  model_->measuring.setAllowed(true);
  model_->live.setAwake(true);
}

void PrepareWorkspace::hideEvent(QHideEvent* event) {
  ui::Workspace::hideEvent(event);
  model_->measuring.setAllowed(false);
  model_->live.setAwake(false);
}

}  // namespace insonate::prepare
