#include "EditingFeature.h"

#include "../layout/PathColumn.h"
#include "../layout/PrepareLayout.h"
#include "../model/CaseChanges.h"
#include "../model/Notice.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Workspace.h>

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>

namespace insonate::prepare {
namespace {

constexpr const char *kUndo = "prepare.editing.undo", *kRedo = "prepare.editing.redo";

/// Adds an action whose keys work in the whole workspace.
void addTo(QWidget& workspace, QAction& action, const char* icon, const QList<QKeySequence>& keys, const char* name) {
  action.setObjectName(QLatin1String(name));
  action.setIcon(ui::icon(QLatin1String(icon)));
  action.setShortcuts(keys);
  action.setShortcutContext(Qt::WidgetWithChildrenShortcut);
  workspace.addAction(&action);
}

}  // namespace

EditingFeature::EditingFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  makeUndo();
  makeSave();
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(actionButton(undo_, Qt::ToolButtonIconOnly));
  box->addWidget(actionButton(redo_, Qt::ToolButtonIconOnly));
  box->addStretch(1);
  box->addWidget(actionButton(save_, Qt::ToolButtonTextBesideIcon));
  layout_.path().addFoot(row);
}

void EditingFeature::makeUndo() {
  QUndoStack& stack = model_.openCase.undoStack();
  undo_ = stack.createUndoAction(this, tr("Undo"));
  redo_ = stack.createRedoAction(this, tr("Redo"));
  addTo(layout_.workspace(), *undo_, "undo", {QKeySequence(QStringLiteral("Ctrl+Z"))}, "undo");
  addTo(layout_.workspace(), *redo_, "redo",
        {QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))}, "redo");
  commands().beginSection(tr("Case"));
  commands().add(kUndo, tr("undoes the last change"), *undo_);
  commands().add(kRedo, tr("redoes the last undone change"), *redo_);
  // The notice of the change would otherwise stay although the change is undone.
  for (QAction* action : {undo_, redo_})
    connect(action, &QAction::triggered, this, [this] { model_.notice.showMessage({}); });
  connect(&stack, &QUndoStack::undoTextChanged, undo_, [this](const QString& what) {
    undo_->setToolTip(commands().toolTip(what.isEmpty() ? tr("Nothing to undo") : tr("Undo: %1").arg(what), kUndo));
  });
  connect(&stack, &QUndoStack::redoTextChanged, redo_, [this](const QString& what) {
    redo_->setToolTip(commands().toolTip(what.isEmpty() ? tr("Nothing to redo") : tr("Redo: %1").arg(what), kRedo));
  });
}

void EditingFeature::makeSave() {
  save_ = new QAction(tr("Save case"), this);
  addTo(layout_.workspace(), *save_, "save", {}, "saveCase");  // Ctrl+S belongs to the window
  connect(save_, &QAction::triggered, this, [this] { Q_EMIT layout_.workspace().saveRequested(); });
  connect(&model_.openCase, &OpenCase::caseChanged, save_, [this] { refreshSave(); });
  connect(&model_.openCase, &OpenCase::originChanged, save_, [this] { refreshSave(); });
  connect(&model_.changes, &CaseChanges::changed, save_, [this] { refreshSave(); });
  refreshSave();
}

void EditingFeature::refreshSave() {
  const bool isChanged = model_.changes.isUnsaved() || model_.changes.unpromptedEdit();
  const bool hasNoFolder = model_.openCase.origin().folder.isEmpty();
  save_->setEnabled(model_.openCase.patient() && (isChanged || hasNoFolder));
  save_->setToolTip(!model_.openCase.patient() ? QString()
                    : hasNoFolder              ? tr("Writes the case to a folder that you choose (Ctrl+S)")
                    : isChanged ? tr("Writes the title and the appearance of structures to the case's folder (Ctrl+S)")
                                : tr("Everything is saved"));
}

}  // namespace insonate::prepare
