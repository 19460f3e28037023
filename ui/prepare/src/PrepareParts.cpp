#include "PrepareParts.h"

#include "KeyTable.h"
#include "check/FindingsList.h"
#include "guide/GuidePointer.h"
#include "guide/GuideSession.h"
#include "labels/LabelFollowers.h"
#include "labels/LabelSession.h"
#include "layout/CaseViews.h"
#include "layout/PathPanel.h"
#include "layout/RightColumn.h"
#include "live/UltrasoundPane.h"
#include "measure/LabellingMeasure.h"
#include "model/CaseChanges.h"
#include "model/CaseMeasuring.h"
#include "model/Crosshair.h"
#include "model/LivePatient.h"
#include "model/OpenCase.h"
#include "model/SliceSettings.h"
#include "model/StatusLine.h"
#include "model/StructureAppearance.h"
#include "model/StructureList.h"
#include "structures/StructureTable.h"
#include "tools/SceneTools.h"
#include "tools/SliceTools.h"
#include "tools/ToolBar.h"

#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/HistogramEditor.h>
#include <insonate/ui/KeyOffer.h>
#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>

#include <QAction>
#include <QKeyEvent>
#include <QSettings>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr double kOpacityStep = 0.05;
constexpr int kLeft_px = 284, kRight_px = 362;

}  // namespace

PrepareWorkspace::Parts::Parts(PrepareWorkspace& workspace, ui::TaskBar& tasks)
    : shared(makePrepareModel(tasks, workspace)), guide(*new GuideSession(shared, &workspace)), workspace_(workspace) {
  pages_ = new QStackedLayout(&workspace);
  pages_->setContentsMargins(0, 0, 0, 0);
  buildEmpty();
  columns = new QSplitter(Qt::Horizontal, &workspace);
  columns->setObjectName(QStringLiteral("prepareColumns"));
  columns->setChildrenCollapsible(false);
  path = new PathPanel(shared, guide, tasks);
  path->setMinimumWidth(kLeft_px);
  views = new CaseViews(shared);
  columns->addWidget(path);
  columns->addWidget(buildMiddle());
  right_ = new RightColumn(shared, *tools_, views->sharedScene());
  columns->addWidget(right_);
  columns->setStretchFactor(0, 0);
  columns->setStretchFactor(1, 1);
  columns->setStretchFactor(2, 0);
  columns->setSizes({kLeft_px, 1000, kRight_px});
  pages_->addWidget(empty);
  pages_->addWidget(columns);
  makeActions();
  connectParts();
}

PrepareWorkspace::Parts::~Parts() = default;

void PrepareWorkspace::Parts::buildEmpty() {
  empty = new ui::EmptyWorkspace(
      {QStringLiteral("prepare"),
       tr("Prepare a case"),
       {tr("Drop a case folder, a folder of DICOM files, or an NRRD, NIfTI or MetaImage file here."),
        tr("A guide leads from an imported CT to a labeled neck. The check lists findings; once there are no errors, "
           "publish the case for trainees.")},
       {},
       {}});
  empty->setObjectName(QStringLiteral("prepareEmpty"));
}

QWidget* PrepareWorkspace::Parts::buildMiddle() {
  tools_ = new ToolSession(shared, &workspace_);
  auto* middle = new QWidget;
  auto* box = new QVBoxLayout(middle);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  box->addWidget(new ToolBar(*tools_));
  box->addWidget(views, 1);
  return middle;
}

void PrepareWorkspace::Parts::makeActions() {
  const auto add = [this](QAction* action, const char* icon, const QList<QKeySequence>& keys, const char* name) {
    action->setObjectName(QLatin1String(name));
    action->setIcon(ui::icon(QLatin1String(icon)));
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    workspace_.addAction(action);
    return action;
  };
  QUndoStack& stack = shared.openCase.undoStack();
  QAction* undo =
      add(stack.createUndoAction(&workspace_, tr("Undo")), "undo", {QKeySequence(QStringLiteral("Ctrl+Z"))}, "undo");
  QAction* redo = add(stack.createRedoAction(&workspace_, tr("Redo")), "redo",
                      {QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))}, "redo");
  save_ = add(new QAction(tr("Save case"), &workspace_), "save", {}, "saveCase");  // Ctrl+S belongs to the window
  connect(save_, &QAction::triggered, this, [this] { Q_EMIT workspace_.saveWanted(); });
  connect(&stack, &QUndoStack::undoTextChanged, undo, [undo](const QString& what) {
    undo->setToolTip(what.isEmpty() ? tr("Nothing to undo (Ctrl+Z)") : tr("Undo: %1 (Ctrl+Z)").arg(what));
  });
  connect(&stack, &QUndoStack::redoTextChanged, redo, [redo](const QString& what) {
    redo->setToolTip(what.isEmpty() ? tr("Nothing to redo (Ctrl+Y)") : tr("Redo: %1 (Ctrl+Y)").arg(what));
  });
  path->setEditActions(undo, redo, save_);
  refreshSave();
}

void PrepareWorkspace::Parts::connectParts() {
  for (ui::ViewWidget* view : views->widgets()) view->focusProxy()->installEventFilter(&workspace_);
  right_->ultrasound().widget().focusProxy()->installEventFilter(&workspace_);
  auto* pointer = new GuidePointer(guide, shared, this);
  for (int n = 0; n < CaseViews::kSlices; ++n) pointer->watch(*views->widgets()[std::size_t(n)], views->slice(n));
  connect(&guide, &GuideSession::clicksChanged, views, [this] { views->setClicks(guide.shownClicks_mm()); });
  // The filter that was installed last receives events first: a selected tool gets the mouse before the guide.
  new SliceTools(*views, *tools_, shared, views);
  new SceneTools(*views, *tools_, views);
  connect(&shared.openCase, &OpenCase::caseChanged, this, [this] {
    pages_->setCurrentWidget(shared.openCase.patient() ? static_cast<QWidget*>(columns) : empty);
    right_->scene().setCase(shared.openCase.patient());
    refreshSave();
    refreshReady();
  });
  connect(&shared.slices, &SliceSettings::changed, this,
          [this] { right_->scene().histogram().setWindowLevel(shared.slices.windowLevel()); });
  connect(&shared.changes, &CaseChanges::changed, this, [this] {
    refreshSave();
    Q_EMIT workspace_.editsChanged();
  });
  connect(&shared.openCase, &OpenCase::originChanged, this, [this] { refreshSave(); });
  connect(&shared.statusLine, &StatusLine::changed, this, [this] { Q_EMIT workspace_.statusChanged(); });
  connect(&shared.measuring, &CaseMeasuring::changed, this, [this] {
    const auto& measures = shared.measuring.measures();
    right_->setCheckRemark(measures ? findingCount(measures->findings) : QString());
    refreshReady();
  });
  connect(&shared.live, &LivePatient::stateChanged, this, [this] {
    refreshReady();
    Q_EMIT workspace_.statusChanged();
  });
  connect(&shared.followers, &LabelFollowers::restChanged, this, [this] { refreshReady(); });
  connect(&shared.labelling, &LabelSession::busyChanged, this, [this] { refreshReady(); });
  views->setRested([this] { refreshReady(); });
  connect(tools_, &ToolSession::toolChanged, this, [this] { showTool(); });
  connect(&guide, &GuideSession::changed, this, [this] { showMouseOwner(); });
  connect(path, &PathPanel::checkChosen, this, [this] { right_->setCheckShown(true); });
  connect(right_, &RightColumn::labelWanted, this, [this](int label) { makeStructure(std::uint8_t(label)); });
  // The guide would otherwise receive the clicks that set a place.
  connect(right_, &RightColumn::markingBegun, this, [this] { path->showGuide(false); });
}

void PrepareWorkspace::Parts::refreshSave() {
  const bool changed = shared.changes.isUnsaved() || shared.changes.quietEdit(),
             nowhere = shared.openCase.origin().folder.isEmpty();
  save_->setEnabled(shared.openCase.patient() && (changed || nowhere));
  save_->setToolTip(!shared.openCase.patient() ? QString()
                    : nowhere                  ? tr("Writes the case to a folder that you choose (Ctrl+S)")
                    : changed ? tr("Writes the title and the appearance of structures to the case's folder (Ctrl+S)")
                              : tr("Everything is saved"));
}

void PrepareWorkspace::Parts::refreshReady() {
  using State = CaseMeasuring::State;
  const State state = shared.measuring.state();
  const bool now = shared.openCase.patient() && (state == State::Done || state == State::Stopped) &&
                   shared.live.isSettled() && views->isAtRest() && shared.followers.isAtRest() &&
                   !shared.labelling.isBusy();
  if (now == std::exchange(ready, now)) return;
  Q_EMIT workspace_.readyChanged();
}

void PrepareWorkspace::Parts::showTool() {
  showMouseOwner();
  const bool inHand = tools_->tool() != nullptr;
  right_->setToolShown(inHand);
  path->table().setToolInHand(inHand);
}

/// With the guide, if it has a step for the structure.
void PrepareWorkspace::Parts::makeStructure(std::uint8_t label) {
  if (guide.goToStepFor(label)) return path->showGuide(true);
  shared.structures.add(label);
  path->showGuide(false);
}

void PrepareWorkspace::Parts::showMouseOwner() {
  right_->setToolRemark(guide.isShown() ? tr("is active; the guide waits") : QString());
}

QString PrepareWorkspace::Parts::engineText() const {
  if (!shared.openCase.patient() || !shared.live.shown()) return {};
  const bool onCard = shared.live.shown()->engine == "glsl";
  return (onCard ? tr("graphics card   %1 ms") : tr("processor   %1 ms")).arg(shared.live.shown()->frame_ms, 4, 'f', 1);
}

void PrepareWorkspace::Parts::setAwake(bool awake) {
  shared.measuring.setAllowed(awake);
  shared.live.setAwake(awake);
}

void PrepareWorkspace::Parts::stop() {
  shared.measuring.setAllowed(false);
  shared.live.stop();
}

bool PrepareWorkspace::Parts::key(const QKeyEvent& event, bool doIt) {
  const KeyRow* row = rowFor(event);
  if (!row || !shared.openCase.patient()) return false;
  // Without a tool, these keys are the window's.
  const bool ofTool = row->command == Command::ApplyTool || row->command == Command::LeaveTool;
  if (ofTool && !tools_->tool()) return false;
  if (doIt) act(*row);
  return true;
}

void PrepareWorkspace::Parts::act(const KeyRow& row) {
  const std::uint8_t label = shared.structures.selected();
  constexpr double kBrushStep = 1.15;
  switch (row.command) {
    case Command::LabelsFainter:
      return shared.slices.setLabelOpacity(shared.slices.labelOpacity() - kOpacityStep);
    case Command::LabelsStronger:
      return shared.slices.setLabelOpacity(shared.slices.labelOpacity() + kOpacityStep);
    case Command::ToggleLabels:
      return shared.slices.setLabelsShown(!shared.slices.labelsShown());
    case Command::PreviousStructure:
      return shared.structures.selectNext(-1);
    case Command::NextStructure:
      return shared.structures.selectNext(1);
    case Command::ToggleStructure:
      return shared.appearance.setVisible(label, !shared.appearance.look(label).visible);
    case Command::CheckPage:
      return right_->setCheckShown(!right_->showsCheck());
    case Command::Start:
      return shared.crosshair.goToStart();
    case Command::Tool:
      return tools_->choose(toolOfKey(row.key, tools_->tool() ? tools_->tool()->id : QString()));
    case Command::LastTool:
      return tools_->chooseLast();
    case Command::ApplyTool:
      return tools_->apply();
    case Command::LeaveTool:
      return tools_->leave();
    case Command::LargerBrush:
      return tools_->scaleBrush(kBrushStep);
    case Command::SmallerBrush:
      return tools_->scaleBrush(1 / kBrushStep);
    case Command::NextState:
      return shared.structures.toNextState(label);
    case Command::LockStructure:
      return shared.labelling.setLocked(label, !shared.labelling.rules().locked.test(label));
  }
}

bool PrepareWorkspace::Parts::canvasEvent(QEvent* event) {
  return ui::offerKey(*event, [this](const QKeyEvent& pressed, bool act) { return key(pressed, act); });
}

void PrepareWorkspace::Parts::saveLayout(QSettings& settings) const {
  settings.setValue(QStringLiteral("columns"), columns->saveState());
  settings.setValue(QStringLiteral("views"), views->saveState());
  right_->save(settings);
  shared.slices.save(settings);
  settings.beginGroup(QStringLiteral("scene"));
  right_->scene().save(settings);
  settings.endGroup();
  shared.appearance.saveHabits(settings);
}

void PrepareWorkspace::Parts::restoreLayout(QSettings& settings) {
  columns->restoreState(settings.value(QStringLiteral("columns")).toByteArray());
  views->restoreState(settings.value(QStringLiteral("views")).toByteArray());
  right_->restore(settings);
  shared.slices.restore(settings);
  settings.beginGroup(QStringLiteral("scene"));
  right_->scene().restore(settings);
  settings.endGroup();
  shared.appearance.restoreHabits(settings);
}

void PrepareWorkspace::Parts::measureLabelling(int repeats, std::function<void(std::vector<LabellingTime>)> done) {
  measure_ = std::make_unique<LabellingMeasure>(shared, *tools_, *views, repeats, std::move(done));
}

}  // namespace insonate::prepare
