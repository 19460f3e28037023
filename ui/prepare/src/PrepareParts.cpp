#include "PrepareParts.h"

#include "KeyTable.h"
#include "check/FindingsList.h"
#include "guide/GuidePointer.h"
#include "guide/GuideSession.h"
#include "live/UltrasoundPane.h"
#include "measure/LabellingMeasure.h"
#include "panel/PathPanel.h"
#include "panel/RightColumn.h"
#include "table/StructureTable.h"
#include "tool/SceneTools.h"
#include "tool/SliceTools.h"
#include "tool/ToolBar.h"
#include "views/CaseViews.h"

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
#include <cmath>

namespace insonate::prepare {
namespace {

constexpr double kOpacityStep = 0.05;
constexpr int kLeft_px = 284, kRight_px = 362;

}  // namespace

PrepareWorkspace::Parts::Parts(PrepareWorkspace& workspace, ui::TaskBar& tasks)
    : session(*new PrepareSession(tasks, &workspace)),
      guide(*new GuideSession(session, &workspace)),
      workspace_(workspace) {
  pages_ = new QStackedLayout(&workspace);
  pages_->setContentsMargins(0, 0, 0, 0);
  buildEmpty();
  columns = new QSplitter(Qt::Horizontal, &workspace);
  columns->setObjectName(QStringLiteral("prepareColumns"));
  columns->setChildrenCollapsible(false);
  path = new PathPanel(session, guide, tasks);
  path->setMinimumWidth(kLeft_px);
  views = new CaseViews(session);
  columns->addWidget(path);
  columns->addWidget(buildMiddle());
  right_ = new RightColumn(session, *tools_, views->sharedScene());
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
  tools_ = new ToolSession(session, &session);
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
  QUndoStack& stack = session.undoStack();
  QAction* undo =
      add(stack.createUndoAction(&workspace_, tr("Undo")), "undo", {QKeySequence(QStringLiteral("Ctrl+Z"))}, "undo");
  QAction* redo = add(stack.createRedoAction(&workspace_, tr("Redo")), "redo",
                      {QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))}, "redo");
  save_ = add(new QAction(tr("Save case"), &workspace_), "save", {}, "saveCase");  // Ctrl+S is the window's
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
  auto* pointer = new GuidePointer(guide, session, this);
  for (int n = 0; n < CaseViews::kSlices; ++n) pointer->watch(*views->widgets()[std::size_t(n)], views->slice(n));
  connect(&guide, &GuideSession::clicksChanged, views, [this] { views->setClicks(guide.shownClicks_mm()); });
  // The filter installed last sees events first: a tool in hand gets the mouse before the guide.
  new SliceTools(*views, *tools_, session, views);
  new SceneTools(*views, *tools_, views);
  connect(&session, &PrepareSession::caseChanged, this, [this] {
    pages_->setCurrentWidget(session.patient() ? static_cast<QWidget*>(columns) : empty);
    right_->scene().setCase(session.patient());
    refreshSave();
    refreshReady();
  });
  connect(&session, &PrepareSession::slicesChanged, this,
          [this] { right_->scene().histogram().setWindowLevel(session.windowLevel()); });
  connect(&session, &PrepareSession::editsChanged, this, [this] {
    refreshSave();
    Q_EMIT workspace_.editsChanged();
  });
  connect(&session, &PrepareSession::originChanged, this, [this] { refreshSave(); });
  connect(&session, &PrepareSession::messageChanged, this, [this] { Q_EMIT workspace_.statusChanged(); });
  connect(&session.measuring(), &CaseMeasuring::changed, this, [this] {
    const auto& measures = session.measuring().measures();
    right_->setCheckRemark(measures ? findingCount(measures->findings) : QString());
    refreshReady();
  });
  connect(&session.live(), &LivePatient::stateChanged, this, [this] {
    refreshReady();
    Q_EMIT workspace_.statusChanged();
  });
  connect(&session.followers(), &LabelFollowers::restChanged, this, [this] { refreshReady(); });
  connect(&session.labelling(), &LabelSession::busyChanged, this, [this] { refreshReady(); });
  views->setRested([this] { refreshReady(); });
  connect(tools_, &ToolSession::toolChanged, this, [this] { showTool(); });
  connect(&guide, &GuideSession::changed, this, [this] { showMouseOwner(); });
  connect(path, &PathPanel::checkChosen, this, [this] { right_->setCheckShown(true); });
  connect(right_, &RightColumn::labelWanted, this, [this](int label) { makeStructure(std::uint8_t(label)); });
  // The guide would take the clicks that say where a place is.
  connect(right_, &RightColumn::markingBegun, this, [this] { path->showGuide(false); });
}

void PrepareWorkspace::Parts::refreshSave() {
  const bool changed = session.isUnsaved() || session.quietEdit(), nowhere = session.origin().folder.isEmpty();
  save_->setEnabled(session.patient() && (changed || nowhere));
  save_->setToolTip(!session.patient() ? QString()
                    : nowhere          ? tr("Writes the case to a folder that you choose (Ctrl+S)")
                    : changed          ? tr("Writes title and looks of structures to the case's folder (Ctrl+S)")
                                       : tr("Everything is saved"));
}

void PrepareWorkspace::Parts::refreshReady() {
  using State = CaseMeasuring::State;
  const State state = session.measuring().state();
  const bool now = session.patient() && (state == State::Done || state == State::Stopped) &&
                   session.live().isSettled() && views->isAtRest() && session.followers().isAtRest() &&
                   !session.labelling().isBusy();
  if (now == std::exchange(ready, now)) return;
  Q_EMIT workspace_.readyChanged();
}

void PrepareWorkspace::Parts::showTool() {
  showMouseOwner();
  const bool inHand = tools_->tool() != nullptr;
  right_->setToolShown(inHand);
  path->table().setToolInHand(inHand);
}

/// With the guide, where it has a step for it.
void PrepareWorkspace::Parts::makeStructure(std::uint8_t label) {
  if (guide.goToStepFor(label)) return path->showGuide(true);
  session.addStructure(label);
  path->showGuide(false);
}

void PrepareWorkspace::Parts::showMouseOwner() {
  right_->setToolRemark(guide.isShown() ? tr("is active; the guide waits") : QString());
}

QString PrepareWorkspace::Parts::engineText() const {
  if (!session.patient() || !session.live().shown()) return {};
  const bool onCard = session.live().shown()->engine == "glsl";
  return (onCard ? tr("graphics card   %1 ms") : tr("processor   %1 ms"))
      .arg(session.live().shown()->frame_ms, 4, 'f', 1);
}

bool PrepareWorkspace::Parts::key(const QKeyEvent& event, bool doIt) {
  const KeyRow* row = rowFor(event);
  if (!row || !session.patient()) return false;
  // Without a tool, these are the window's.
  const bool ofTool = row->command == Command::ApplyTool || row->command == Command::LeaveTool;
  if (ofTool && !tools_->tool()) return false;
  if (doIt) act(*row);
  return true;
}

void PrepareWorkspace::Parts::act(const KeyRow& row) {
  const std::uint8_t label = session.selected();
  constexpr double kBrushStep = 1.15;
  switch (row.command) {
    case Command::LabelsFainter:
      return session.setLabelOpacity(session.labelOpacity() - kOpacityStep);
    case Command::LabelsStronger:
      return session.setLabelOpacity(session.labelOpacity() + kOpacityStep);
    case Command::ToggleLabels:
      return session.setLabelsShown(!session.labelsShown());
    case Command::PreviousStructure:
      return session.selectNext(-1);
    case Command::NextStructure:
      return session.selectNext(1);
    case Command::ToggleStructure:
      return session.setVisible(label, !session.look(label).visible);
    case Command::CheckPage:
      return right_->setCheckShown(!right_->showsCheck());
    case Command::Start:
      return session.goToStart();
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
      return session.toNextState(label);
    case Command::LockStructure:
      return session.setLocked(label, !session.labelling().rules().locked.test(label));
  }
}

bool PrepareWorkspace::Parts::canvasEvent(QEvent* event) {
  return ui::offerKey(*event, [this](const QKeyEvent& pressed, bool act) { return key(pressed, act); });
}

void PrepareWorkspace::Parts::saveLayout(QSettings& settings) const {
  settings.setValue(QStringLiteral("columns"), columns->saveState());
  settings.setValue(QStringLiteral("views"), views->saveState());
  right_->save(settings);
  settings.setValue(QStringLiteral("window"), session.windowLevel().window_HU);
  settings.setValue(QStringLiteral("level"), session.windowLevel().level_HU);
  settings.setValue(QStringLiteral("labelOpacity"), session.labelOpacity());
  settings.setValue(QStringLiteral("labelsShown"), session.labelsShown());
  settings.setValue(QStringLiteral("labelFill"), session.labelStyle().fill);
  settings.setValue(QStringLiteral("labelOutline"), session.labelStyle().outline);
  settings.setValue(QStringLiteral("outlineWidth"), session.labelStyle().thickness_px);
  settings.setValue(QStringLiteral("placesShown"), session.placesShown());
  settings.beginGroup(QStringLiteral("scene"));
  right_->scene().save(settings);
  settings.endGroup();
  settings.beginWriteArray(QStringLiteral("structures"));
  int index = 0;
  for (const auto& [label, habit] : session.habits()) {
    settings.setArrayIndex(index++);
    settings.setValue(QStringLiteral("label"), int(label));
    settings.setValue(QStringLiteral("opacity"), habit.opacity);
    settings.setValue(QStringLiteral("visible"), habit.visible);
    settings.setValue(QStringLiteral("onSlices"), habit.onSlices);
  }
  settings.endArray();
}

void PrepareWorkspace::Parts::restoreLayout(QSettings& settings) {
  columns->restoreState(settings.value(QStringLiteral("columns")).toByteArray());
  views->restoreState(settings.value(QStringLiteral("views")).toByteArray());
  right_->restore(settings);
  const auto number = [&settings](const char* key, double otherwise) {
    const double value = settings.value(QLatin1String(key), otherwise).toDouble();
    return std::isfinite(value) ? value : otherwise;
  };
  const views::WindowLevel usual;
  session.setWindowLevel({std::clamp(number("window", usual.window_HU), 1.0, 10000.0),
                          std::clamp(number("level", usual.level_HU), -5000.0, 10000.0)});
  session.setLabelOpacity(number("labelOpacity", session.labelOpacity()));
  session.setLabelsShown(settings.value(QStringLiteral("labelsShown"), true).toBool());
  session.setLabelStyle({settings.value(QStringLiteral("labelFill"), true).toBool(),
                         settings.value(QStringLiteral("labelOutline"), true).toBool(),
                         int(std::clamp(number("outlineWidth", 1), 1.0, 8.0))});
  session.setPlacesShown(settings.value(QStringLiteral("placesShown"), true).toBool());
  settings.beginGroup(QStringLiteral("scene"));
  right_->scene().restore(settings);
  settings.endGroup();
  std::map<std::uint8_t, PrepareSession::Habit> habits;
  const int count = settings.beginReadArray(QStringLiteral("structures"));
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    const int label = settings.value(QStringLiteral("label")).toInt();
    if (label < 1 || label > 255) continue;
    habits[std::uint8_t(label)] = {std::clamp(number("opacity", 1), 0.0, 1.0),
                                   settings.value(QStringLiteral("visible"), true).toBool(),
                                   std::clamp(number("onSlices", defaultShareOnSlices(std::uint8_t(label))), 0.0, 1.0)};
  }
  settings.endArray();
  session.setHabits(std::move(habits));
}

}  // namespace insonate::prepare
