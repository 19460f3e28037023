#include "KeyTable.h"
#include "PrepareParts.h"
#include "guide/GuideSession.h"
#include "layout/CaseViews.h"
#include "layout/PathPanel.h"
#include "model/CaseChanges.h"
#include "model/Notice.h"
#include "model/OpenCase.h"
#include "model/StatusLine.h"

#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/ui/EmptyWorkspace.h>

#include <QKeyEvent>
#include <QSplitter>

namespace insonate::prepare {

PrepareWorkspace::PrepareWorkspace(ui::TaskBar& tasks, QWidget* parent)
    : ui::Workspace(parent), parts_(std::make_unique<Parts>(*this, tasks)) {
  setObjectName(QStringLiteral("prepare"));
}

PrepareWorkspace::~PrepareWorkspace() {
  parts_->stop();
  // The widgets refer to the model and are deleted first.
  delete parts_->columns;
  delete parts_->empty;
}

void PrepareWorkspace::offer(QAction* action) {
  parts_->empty->offer(action);
}

void PrepareWorkspace::setCaseActions(QAction* open, QAction* import, QAction* reload) {
  parts_->path->setCaseActions(open, import, reload);
}

void PrepareWorkspace::setOpening(const QString& what) {
  parts_->empty->showOpening(what);
}

void PrepareWorkspace::setOrigin(const ui::CaseOrigin& origin) {
  parts_->shared.openCase.setOrigin(origin);
}

void PrepareWorkspace::setCase(std::shared_ptr<const PatientCase> patient) {
  parts_->shared.openCase.setCase(std::move(patient));
}

ui::CaseEdit PrepareWorkspace::unsavedEdit() const {
  return parts_->shared.changes.unsavedEdit();
}

ui::CaseEdit PrepareWorkspace::quietEdit() const {
  return parts_->shared.changes.quietEdit();
}

void PrepareWorkspace::caseSaved(std::shared_ptr<const PatientCase> patient) {
  parts_->shared.openCase.replaceCase(std::move(patient));
  parts_->views->replaceCase();
  const QString folder = parts_->shared.openCase.origin().folder;
  if (folder.isEmpty()) return;
  if (auto ok = parts_->guide.saveRecipe(folder.toStdString()); !ok)
    parts_->shared.notice.say(tr("The case is saved, but the recipe of its labels is not: %1")
                                  .arg(QString::fromStdString(ok.error().message)));
}

QString PrepareWorkspace::statusText() const {
  return parts_->shared.statusLine.text();
}

QString PrepareWorkspace::engineText() const {
  return parts_->engineText();
}

bool PrepareWorkspace::isReady() const {
  return parts_->ready;
}

std::vector<ui::Shortcut> PrepareWorkspace::shortcuts() const {
  std::vector<ui::Shortcut> all;
  for (const KeyRow& row : keyTable())
    if (*row.keys) all.push_back({tr(row.keys), tr(row.meaning)});
  return all;
}

void PrepareWorkspace::saveLayout(QSettings& settings) const {
  parts_->saveLayout(settings);
}

void PrepareWorkspace::restoreLayout(QSettings& settings) {
  parts_->restoreLayout(settings);
}

void PrepareWorkspace::measureLabelling(int repeats, std::function<void(std::vector<LabellingTime>)> done) {
  parts_->measureLabelling(repeats, std::move(done));
}

void PrepareWorkspace::stop() {
  parts_->stop();
}

bool PrepareWorkspace::eventFilter(QObject* watched, QEvent* event) {
  return parts_->canvasEvent(event) || ui::Workspace::eventFilter(watched, event);
}

void PrepareWorkspace::keyPressEvent(QKeyEvent* event) {
  if (!parts_->key(*event, true)) ui::Workspace::keyPressEvent(event);
}

void PrepareWorkspace::showEvent(QShowEvent* event) {
  ui::Workspace::showEvent(event);
  parts_->setAwake(true);
}

void PrepareWorkspace::hideEvent(QHideEvent* event) {
  ui::Workspace::hideEvent(event);
  parts_->setAwake(false);
}

}  // namespace insonate::prepare
