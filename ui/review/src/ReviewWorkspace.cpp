#include "KeyTable.h"
#include "ReviewParts.h"
#include "home/ReviewHome.h"
#include "judge/JudgeDesk.h"
#include "list/AttemptList.h"

#include <insonate/review/ReviewWorkspace.h>

#include <QKeyEvent>

namespace insonate::review {

ReviewWorkspace::ReviewWorkspace(ui::TaskBar& tasks, QWidget* parent)
    : ui::Workspace(parent), parts_(std::make_unique<Parts>(*this, tasks)) {}

ReviewWorkspace::~ReviewWorkspace() {
  stop();
}

void ReviewWorkspace::offer(QAction* action) {
  parts_->list->offer(action);
}

void ReviewWorkspace::saveResult(const QString& file) {
  if (parts_->session.attempt()) parts_->saveResult(file);
}

void ReviewWorkspace::openAttempt(const QString& file) {
  parts_->session.open(file, parts_->tasks);
}

void ReviewWorkspace::setCase(std::shared_ptr<const PatientCase> patient) {
  parts_->session.setPatient(std::move(patient));
}

void ReviewWorkspace::setAccount(ui::Account& account) {
  parts_->home->setAccount(account);
  parts_->judging->setAccount(account);
}

QString ReviewWorkspace::statusText() const {
  if (!parts_->said().isEmpty()) return parts_->said();
  const QString message = parts_->session.message();
  return message.isEmpty() ? parts_->home->statusText() : message;
}

QString ReviewWorkspace::engineText() const {
  const auto& frame = parts_->session.picture().shown();
  return frame ? tr("processor   %1 ms").arg(frame->frame_ms, 4, 'f', 1) : QString();
}

bool ReviewWorkspace::isReady() const {
  return parts_->ready;
}

std::vector<ui::Shortcut> ReviewWorkspace::shortcuts() const {
  std::vector<ui::Shortcut> all;
  for (const KeyRow& row : keyTable())
    if (*row.keys) all.push_back({tr(row.keys), tr(row.meaning)});
  return all;
}

void ReviewWorkspace::saveLayout(QSettings& settings) const {
  parts_->saveLayout(settings);
}

void ReviewWorkspace::restoreLayout(QSettings& settings) {
  parts_->restoreLayout(settings);
}

void ReviewWorkspace::stop() {
  parts_->session.stop();
}

bool ReviewWorkspace::eventFilter(QObject* watched, QEvent* event) {
  return parts_->keyEvent(event) || ui::Workspace::eventFilter(watched, event);
}

void ReviewWorkspace::keyPressEvent(QKeyEvent* event) {
  if (!parts_->key(*event, true)) ui::Workspace::keyPressEvent(event);
}

void ReviewWorkspace::showEvent(QShowEvent* event) {
  ui::Workspace::showEvent(event);
  parts_->session.setAwake(true);
  parts_->list->refresh();
}

void ReviewWorkspace::hideEvent(QHideEvent* event) {
  ui::Workspace::hideEvent(event);
  parts_->session.setAwake(false);
}

}  // namespace insonate::review
