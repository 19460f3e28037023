// The part of the window that closes it, and what it hands on to the workspace.
#include "ClosingQuestion.h"

#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QTimer>

namespace insonate::ui {

bool MainWindow::asksAboutWork() {
  const QString job = tasks_->asksWhenClosed() ? tasks_->title() : QString();
  const bool unsaved = case_.patient && case_.folder.isEmpty() && !case_.builtIn;
  if (sure_ || (job.isEmpty() && !unsaved)) return false;
  if (auto* asked = findChild<ClosingQuestion*>()) {
    asked->raise();
    return true;
  }
  auto* question =
      new ClosingQuestion(job, unsaved ? QString::fromStdString(case_.patient->manifest.title) : QString(), this);
  connect(question, &ClosingQuestion::saveChosen, this, &MainWindow::saveAndClose);
  connect(question, &ClosingQuestion::closeChosen, this, &MainWindow::closeAtOnce);
  // What it asks about has changed.
  connect(tasks_, &TaskBar::runningChanged, question, &QDialog::reject);
  question->open();
  return true;
}

void MainWindow::saveAndClose() {
  // Waits for this save only: a later one does not close the window.
  auto* waiting = new QObject(this);
  connect(loader_, &CaseLoader::saved, waiting, [this, waiting] {
    waiting->deleteLater();
    QTimer::singleShot(0, this, &MainWindow::closeAtOnce);
  });
  connect(loader_, &CaseLoader::failed, waiting, &QObject::deleteLater);
  connect(loader_, &CaseLoader::cancelled, waiting, &QObject::deleteLater);
  chooseTarget();
  if (!tasks_->isRunning()) waiting->deleteLater();
}

void MainWindow::closeAtOnce() {
  sure_ = true;
  close();
}

bool MainWindow::passKey(QKeyEvent& event) {
  // Space freezes, wherever a click left the keyboard. What the workspace does not know comes back to the window.
  Workspace* workspace = currentWorkspace();
  if (passing_ || !workspace || workspace->isAncestorOf(focusWidget()) || focusWidget() == workspace) return false;
  passing_ = true;
  QCoreApplication::sendEvent(workspace, &event);
  passing_ = false;
  return event.isAccepted();
}

void MainWindow::fillView() {
  view_->clear();
  view_->setToolTipsVisible(true);
  view_->addActions(currentWorkspace()->actions());
  if (view_->isEmpty()) view_->addAction(tr("Nothing to choose here"))->setEnabled(false);
}

}  // namespace insonate::ui
